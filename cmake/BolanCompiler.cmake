# SPDX-License-Identifier: MIT
# Language, warnings, floating-point rules and sanitizers, the same for every target of the project.

set(CMAKE_C_STANDARD 17)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND PROJECT_IS_TOP_LEVEL)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()

set(BOLAN_LIBRARIES "") # the libraries that exist, dependants first, for the program, examples and bench

# x87 registers round to 64 bits of mantissa, and only what is stored rounds to float or double: results would depend on
# which values the compiler keeps in registers. SSE2 rounds each operation.
set(bolan_machine_options "")
if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86|x86_64|AMD64|i[3-6]86)$")
    set(bolan_machine_options -msse2 -mfpmath=sse)
    message(STATUS "32-bit x86: compiling with -msse2 -mfpmath=sse; results in x87 registers would differ")
endif()

function(bolan_compile_options target)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include)
    target_compile_definitions(${target} PRIVATE _XOPEN_SOURCE=700)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow
        $<$<COMPILE_LANGUAGE:C>:-Wpedantic -Wconversion -Wno-sign-conversion -Wstrict-prototypes -Wmissing-prototypes>
        $<$<BOOL:${BOLAN_WERROR}>:-Werror>
        ${bolan_machine_options}
        # Whoever embeds Bolan may build with -ffast-math; reassociated sums would be another sea.
        -fno-fast-math
        # A fused multiply-add rounds once where a*b + c rounds twice: with contraction the same sea would differ between
        # machines, instruction sets and optimisation levels.
        -ffp-contract=off
        # Lets sqrt and rint become single instructions. It changes errno, never a result.
        -fno-math-errno
        # Debug information of installed archives names no folder of this machine. A debug build keeps the paths for the
        # debugger.
        $<$<NOT:$<CONFIG:Debug>>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.>
        $<$<NOT:$<CONFIG:Debug>>:-ffile-prefix-map=${CMAKE_BINARY_DIR}=build>)
    if(BOLAN_FUZZ)
        target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
        target_link_options(${target} PUBLIC -fsanitize=fuzzer-no-link)
    endif()
    if(BOLAN_SANITIZE)
        # The checks in the code hide from GCC that an array is written before it is read.
        target_compile_options(${target} PRIVATE -fsanitize=${BOLAN_SANITIZE} -fno-omit-frame-pointer
            -fno-sanitize-recover=all -Wno-maybe-uninitialized)
        target_link_options(${target} PUBLIC -fsanitize=${BOLAN_SANITIZE})
    endif()
endfunction()

# A library, static or with BUILD_SHARED_LIBS shared, with the public headers; or nothing while its folder is empty.
macro(bolan_add_library target)
    if(NOT "${ARGN}" STREQUAL "")
        add_library(${target} ${ARGN})
        add_library(bolan::${target} ALIAS ${target})
        bolan_compile_options(${target})
        target_include_directories(${target} PUBLIC
            $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
            PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/shaders) # the latter for shared/*.glsl, also C
        # Before 1.0 a minor version may change the API, so programs ask for major.minor.
        set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION}
            SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH $ORIGIN
            C_VISIBILITY_PRESET hidden)
        list(PREPEND BOLAN_LIBRARIES ${target})
    endif()
endmacro()

# Sets <out> to the libraries whose public headers the files include and that this build does not have.
function(bolan_missing_libraries out)
    set(missing "")
    set(text "")
    foreach(file IN LISTS ARGN)
        file(READ ${file} part)
        string(APPEND text "${part}")
    endforeach()
    foreach(name IN ITEMS content io render)
        if(text MATCHES "#include \"bolan/${name}\\.h\"" AND NOT TARGET bolan_${name})
            list(APPEND missing bolan_${name})
        endif()
    endforeach()
    list(JOIN missing " and " missing)
    set(${out} "${missing}" PARENT_SCOPE)
endfunction()
