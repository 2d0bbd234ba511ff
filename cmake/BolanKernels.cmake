# SPDX-License-Identifier: MIT
# bolan_add_kernels(target file.kernel.c): compiles one wide kernel file once per instruction set into the target.
# The file sees BOLAN_KERNEL_SUFFIX (scalar, generic4, avx2, avx512: append it to every name it exports),
# BOLAN_KERNEL_WIDTH (floats in a register: 1, 4, 8, 16) and BOLAN_KERNEL_<SUFFIX IN CAPITALS>. generic4 has no
# intrinsics: the compiler makes SSE2, NEON or WebAssembly SIMD of it. Other sources of the target see BOLAN_KERNELS_X86
# where all four sets exist; elsewhere the first two do.
# All sets give the same bits, since contraction stays off: AVX-512 holds fused multiply-add, and it must not be used.

set(bolan_kernel_flags_scalar "")
set(bolan_kernel_flags_generic4 "")
set(bolan_kernel_flags_avx2 -mavx2 -mf16c)
set(bolan_kernel_flags_avx512 -mavx512f -mavx512dq -mavx512bw -mavx512vl -mf16c -mprefer-vector-width=512)
set(bolan_kernel_width_scalar 1)
set(bolan_kernel_width_generic4 4)
set(bolan_kernel_width_avx2 8)
set(bolan_kernel_width_avx512 16)

set(BOLAN_KERNEL_OPTIMISATION -O3 CACHE STRING "Optimisation level of the wide kernels, whatever that of the rest")
mark_as_advanced(BOLAN_KERNEL_OPTIMISATION)

if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(bolan_kernel_sets scalar generic4 avx2 avx512)
    add_compile_definitions($<$<COMPILE_LANGUAGE:C>:BOLAN_KERNELS_X86=1>)
else()
    set(bolan_kernel_sets scalar generic4)
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^wasm")
        set(bolan_kernel_flags_generic4 -msimd128)
    endif()
endif()

function(bolan_add_kernels target file)
    get_filename_component(path ${file} ABSOLUTE)
    get_filename_component(stem ${file} NAME_WE)
    get_filename_component(folder ${path} DIRECTORY)
    get_filename_component(folder ${folder} NAME)
    foreach(set IN LISTS bolan_kernel_sets)
        # One source can be in a target once, so each set compiles a one-line file that includes it.
        set(unit ${CMAKE_CURRENT_BINARY_DIR}/kernels/${folder}_${stem}_${set}.c)
        file(CONFIGURE OUTPUT ${unit} CONTENT "#include \"${path}\"\n" @ONLY)
        string(TOUPPER ${set} capitals)
        set_source_files_properties(${unit} PROPERTIES
            COMPILE_DEFINITIONS
                "BOLAN_KERNEL_SUFFIX=${set};BOLAN_KERNEL_WIDTH=${bolan_kernel_width_${set}};BOLAN_KERNEL_${capitals}=1"
            COMPILE_OPTIONS "${BOLAN_KERNEL_OPTIMISATION};-fno-trapping-math;${bolan_kernel_flags_${set}}")
        target_sources(${target} PRIVATE ${unit})
    endforeach()
endfunction()
