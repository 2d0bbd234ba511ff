# SPDX-License-Identifier: MIT
# The default flags of a release build, set before project() sets CMake's. A value on the command line or in the cache
# wins; so does an optimisation or debug level in CFLAGS, CXXFLAGS or CMAKE_<LANG>_FLAGS. As a part of another project,
# Bolan takes that project's flags.

if(CMAKE_SOURCE_DIR STREQUAL CMAKE_CURRENT_SOURCE_DIR)
    foreach(language IN ITEMS C CXX)
        set(given "$ENV{${language}FLAGS} ${CMAKE_${language}_FLAGS}")
        set(flags "")
        if(NOT given MATCHES "(^| )-O")
            list(APPEND flags -O2)
        endif()
        if(NOT given MATCHES "(^| )-g")
            list(APPEND flags -g1)
        endif()
        list(JOIN flags " " flags)
        set(CMAKE_${language}_FLAGS_RELEASE "${flags} -DNDEBUG" CACHE STRING "Flags of a release build")
    endforeach()
endif()
