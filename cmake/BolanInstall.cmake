# SPDX-License-Identifier: MIT
# make install: libraries, public headers, bolan.pc and a CMake package (find_package(bolan); bolan::bolan, ...).
include(CMakePackageConfigHelpers)

if(BOLAN_LIBRARIES)
    install(TARGETS ${BOLAN_LIBRARIES} EXPORT bolanTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(DIRECTORY include/bolan DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
    set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/bolan)
    install(EXPORT bolanTargets NAMESPACE bolan:: DESTINATION ${package_folder})
    configure_package_config_file(cmake/bolanConfig.cmake.in bolanConfig.cmake INSTALL_DESTINATION ${package_folder})
    write_basic_package_version_file(bolanConfigVersion.cmake COMPATIBILITY SameMinorVersion)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/bolanConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/bolanConfigVersion.cmake
        DESTINATION ${package_folder})
    # The prefix is known at installation only: state it from where bolan.pc lies.
    file(RELATIVE_PATH pc_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    configure_file(cmake/bolan.pc.in bolan.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/bolan.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
