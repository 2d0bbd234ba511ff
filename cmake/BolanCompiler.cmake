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
set(CMAKE_C_FLAGS_RELEASE "-O2 -g1 -DNDEBUG")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -g1 -DNDEBUG")

set(BOLAN_LIBRARIES "") # the libraries that exist, dependants first, for the program, examples and bench

function(bolan_compile_options target)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include)
    target_compile_definitions(${target} PRIVATE _XOPEN_SOURCE=700)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow
        $<$<COMPILE_LANGUAGE:C>:-Wpedantic -Wconversion -Wno-sign-conversion -Wstrict-prototypes -Wmissing-prototypes>
        $<$<BOOL:${BOLAN_WERROR}>:-Werror>
        # A fused multiply-add rounds once where a*b + c rounds twice: with contraction the same sea would differ between
        # machines, instruction sets and optimisation levels.
        -ffp-contract=off
        # Lets sqrt and rint become single instructions. It changes errno, never a result.
        -fno-math-errno)
    if(BOLAN_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=${BOLAN_SANITIZE} -fno-omit-frame-pointer
            -fno-sanitize-recover=all)
        target_link_options(${target} PUBLIC -fsanitize=${BOLAN_SANITIZE})
    endif()
endfunction()

# A static library with the public headers, or nothing while its folder is empty.
macro(bolan_add_library target)
    if(NOT "${ARGN}" STREQUAL "")
        add_library(${target} ${ARGN})
        add_library(bolan::${target} ALIAS ${target})
        bolan_compile_options(${target})
        target_include_directories(${target} PUBLIC
            $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
            PRIVATE ${PROJECT_SOURCE_DIR}/src)
        list(PREPEND BOLAN_LIBRARIES ${target})
    endif()
endmacro()
