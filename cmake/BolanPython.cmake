# SPDX-License-Identifier: MIT
# libbolan_all: all libraries in one shared library, which the Python package opens. Without BUILD_SHARED_LIBS the
# archives are linked into it whole, so that nothing is compiled twice; with it, it holds nothing and needs the
# shared ones.

file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/bolan_all.c CONTENT "typedef int bolan_all;\n")
add_library(bolan_all SHARED ${CMAKE_CURRENT_BINARY_DIR}/bolan_all.c)
bolan_compile_options(bolan_all)
set_target_properties(bolan_all PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH $ORIGIN)
target_link_libraries(bolan_all PRIVATE
    $<IF:$<BOOL:${BUILD_SHARED_LIBS}>,-Wl$<COMMA>--no-as-needed,-Wl$<COMMA>--whole-archive>)
foreach(library IN LISTS BOLAN_LIBRARIES)
    target_link_libraries(bolan_all PRIVATE $<TARGET_FILE:${library}>)
endforeach()
target_link_libraries(bolan_all PRIVATE
    $<IF:$<BOOL:${BUILD_SHARED_LIBS}>,-Wl$<COMMA>--as-needed,-Wl$<COMMA>--no-whole-archive>
    ${BOLAN_LIBRARIES} Threads::Threads m) # for what they need themselves
if(BOLAN_INSTALL)
    install(TARGETS bolan_all LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT
        development)
endif()
