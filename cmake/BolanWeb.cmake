# SPDX-License-Identifier: MIT
# What the web page needs, before any target: preset "web", by emscripten.

# Types and constants of OpenGL are those of libepoxy's headers, which are the same for every machine. A folder of its
# own links to them, since /usr/include would bring the host's C library.
find_path(BOLAN_EPOXY_HOST_INCLUDE epoxy/gl.h PATHS /usr/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/headers)
file(CREATE_LINK ${BOLAN_EPOXY_HOST_INCLUDE}/epoxy ${CMAKE_BINARY_DIR}/headers/epoxy SYMBOLIC)
set(BOLAN_EPOXY_INCLUDE ${CMAKE_BINARY_DIR}/headers CACHE PATH "Folder of epoxy/gl.h" FORCE)

set(CMAKE_POSITION_INDEPENDENT_CODE OFF) # one module, linked once

set(BOLAN_WEB_SCENES "" CACHE FILEPATH "scenes.c, which build/bolan_print_scenes writes: the page reads no scene files")
set(BOLAN_WEB_FOLDER ${CMAKE_BINARY_DIR}/web CACHE PATH "Folder of the page")

# The page: index.html, page.css, page.js, bolan.js, bolan.wasm.
function(bolan_add_web_page)
    file(GLOB sources CONFIGURE_DEPENDS apps/web/*.c)
    list(FILTER sources EXCLUDE REGEX "/print_scenes\\.c$")
    add_executable(bolan_web ${sources} ${BOLAN_WEB_SCENES} apps/viewer/fly.c apps/viewer/pace.c apps/viewer/world.c)
    bolan_compile_options(bolan_web)
    target_include_directories(bolan_web PRIVATE apps/web)
    target_link_libraries(bolan_web PRIVATE ${BOLAN_LIBRARIES} m)
    set_target_properties(bolan_web PROPERTIES OUTPUT_NAME bolan RUNTIME_OUTPUT_DIRECTORY ${BOLAN_WEB_FOLDER})
    # JavaScript alone calls what main.c exports, and its inline JavaScript is an extension.
    set_source_files_properties(apps/web/main.c PROPERTIES COMPILE_OPTIONS -Wno-missing-prototypes)
    target_compile_options(bolan_web PRIVATE -Wno-pedantic -Wno-gnu -Wno-dollar-in-identifier-extension)
    target_link_options(bolan_web PRIVATE -O2 -msimd128 -sMODULARIZE=1 -sEXPORT_NAME=createBolan -sENVIRONMENT=web
        -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sALLOW_MEMORY_GROWTH=1 -sINITIAL_MEMORY=134217728
        -sTOTAL_STACK=4194304 --profiling-funcs -sEXPORTED_RUNTIME_METHODS=cwrap -sFILESYSTEM=0 -sDYNAMIC_EXECUTION=0)
    foreach(file IN ITEMS index.html page.css page.js)
        configure_file(apps/web/${file} ${BOLAN_WEB_FOLDER}/${file} COPYONLY)
    endforeach()
endfunction()
