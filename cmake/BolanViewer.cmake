# SPDX-License-Identifier: MIT
# The viewer, as a part of the program bolan_cli. Without a C++ compiler the program is built without it.
include(CheckLanguage)

check_language(CXX)
if(CMAKE_CXX_COMPILER)
    enable_language(CXX)
    pkg_check_modules(sdl2 REQUIRED IMPORTED_TARGET sdl2)
    pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
    target_sources(bolan_cli PRIVATE ${viewer_sources})
    target_include_directories(bolan_cli PRIVATE apps/viewer)
    target_link_libraries(bolan_cli PRIVATE PkgConfig::imgui PkgConfig::sdl2 GL dl)
    target_compile_definitions(bolan_cli PRIVATE BOLAN_HAVE_VIEWER=1
        $<$<CONFIG:Debug>:BOLAN_SHADER_DIR="${CMAKE_CURRENT_SOURCE_DIR}/shaders">)
else()
    message(STATUS "The program is built without the viewer: it needs a C++ compiler")
endif()
