# SPDX-License-Identifier: MIT
# make install: program, libraries, public headers, a .pc file per library, and a CMake package (find_package(bolan);
# bolan::bolan, bolan::bolan_content, bolan::bolan_io, bolan::bolan_render). Components: `program`; `libraries`, what
# a program that is linked already needs; `development`. cmake --install build --component NAME installs one of them.
include(CMakePackageConfigHelpers)

# Installed programs and libraries find the libraries from where they lie themselves.
if(TARGET bolan_cli)
    file(RELATIVE_PATH bin_to_lib /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(bolan_cli PROPERTIES INSTALL_RPATH $ORIGIN/${bin_to_lib})
    install(TARGETS bolan_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
    install(FILES scenes/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/bolan COMPONENT program)
endif()

install(TARGETS ${BOLAN_LIBRARIES} EXPORT bolanTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT development
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/bolan DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
    FILES_MATCHING PATTERN "*.h")

# GLSL that a program of the host's includes.
set(bolan_shader_folder ${CMAKE_INSTALL_DATADIR}/bolan/shaders)
if(TARGET bolan_render)
    install(FILES shaders/include/bolan_fields.glsl DESTINATION ${bolan_shader_folder} COMPONENT development)
endif()

# An archive leaves its own needs to whoever links it: the CMake package looks for these, and the .pc files name them.
set(bolan_package_modules "")
if(NOT BUILD_SHARED_LIBS AND TARGET bolan_io)
    list(APPEND bolan_package_modules yaml=yaml-0.1)
    foreach(format IN ITEMS gdal assimp zlib netcdf)
        if(TARGET PkgConfig::${format})
            list(APPEND bolan_package_modules ${format}=${format})
        endif()
    endforeach()
endif()
if(NOT BUILD_SHARED_LIBS AND TARGET bolan_render)
    foreach(module IN ITEMS epoxy egl)
        if(TARGET PkgConfig::${module})
            list(APPEND bolan_package_modules ${module}=${module})
        endif()
    endforeach()
endif()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/bolan)
install(EXPORT bolanTargets NAMESPACE bolan:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(cmake/bolanConfig.cmake.in bolanConfig.cmake INSTALL_DESTINATION ${package_folder}
    PATH_VARS bolan_shader_folder)
write_basic_package_version_file(bolanConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/bolanConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/bolanConfigVersion.cmake
    DESTINATION ${package_folder} COMPONENT development)

# bolan_install_pc(library description "required .pc files" needs of the archive...)
function(bolan_install_pc pc_name pc_description pc_requires)
    set(pc_variables "")
    if(pc_name STREQUAL bolan_render)
        set(pc_variables "shaderdir=\${prefix}/${bolan_shader_folder}\n")
    endif()
    # The prefix is known at installation only: state it from where the .pc file lies.
    file(RELATIVE_PATH pc_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    set(pc_needs "")
    if(NOT BUILD_SHARED_LIBS)
        # In Libs, not Libs.private: with archives alone a plain `pkg-config --libs` has to be enough too.
        foreach(need IN LISTS ARGN)
            string(REGEX REPLACE "^-L" "" folder ${need})
            if(NOT folder IN_LIST CMAKE_C_IMPLICIT_LINK_DIRECTORIES)
                string(APPEND pc_needs " ${need}")
            endif()
        endforeach()
    endif()
    configure_file(cmake/bolan.pc.in ${pc_name}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${pc_name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
endfunction()
bolan_install_pc(bolan "the core, without files and OpenGL" "" -pthread -lm)
bolan_install_pc(bolan_content "generated grounds and models" "bolan = ${PROJECT_VERSION}" -lm)
if(TARGET bolan_io)
    set(io_needs ${yaml_LDFLAGS})
    if(BOLAN_WITH_GDAL)
        list(APPEND io_needs ${gdal_LDFLAGS})
    endif()
    foreach(format IN ITEMS assimp zlib netcdf)
        string(TOUPPER ${format} capitals)
        if(BOLAN_WITH_${capitals})
            list(APPEND io_needs ${${format}_LDFLAGS})
        endif()
    endforeach()
    if(BOLAN_WITH_OPENEXR)
        get_filename_component(openexr_folder ${OPENEXR_CORE_LIBRARY} DIRECTORY)
        get_filename_component(openexr_name ${OPENEXR_CORE_LIBRARY} NAME_WE)
        string(REGEX REPLACE "^lib" "-l" openexr_name ${openexr_name})
        list(APPEND io_needs -L${openexr_folder} ${openexr_name})
    endif()
    bolan_install_pc(bolan_io "files: scenes, rasters, models, images, video" "bolan_content = ${PROJECT_VERSION}"
        ${io_needs} -lm)
endif()
if(TARGET bolan_render)
    bolan_install_pc(bolan_render "drawing with OpenGL" "bolan = ${PROJECT_VERSION}" ${epoxy_LDFLAGS} ${egl_LDFLAGS}
        -lm)
endif()
