# What the C libraries libstiffaxis and libstiffaxis_rod have in common: visible names, numbers, packages for those who build on them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# abi(TARGET NAME): libNAME.so, where only the names of cmake/abi/NAME.txt are visible, under the version NAME_<major>;
# tests/cli/abi.sh holds it to the list.
function(abi target name)
    set(list ${PROJECT_SOURCE_DIR}/cmake/abi/${name}.txt)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
    file(STRINGS ${list} names REGEX "^[a-z]")
    list(JOIN names ";\n        " names)
    string(TOUPPER ${name} version)
    set(map ${CMAKE_BINARY_DIR}/${name}.map)
    file(CONFIGURE OUTPUT ${map} CONTENT
        "${version}_${PROJECT_VERSION_MAJOR} {\n    global:\n        ${names};\n    local:\n        *;\n};\n")
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} LINKER_LANGUAGE C LINK_DEPENDS ${map}
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
    target_link_options(${target} PRIVATE -Wl,--version-script=${map} -Wl,--gc-sections)
endfunction()

# c_package(NAME PC name COMPONENT name DESCRIPTION words TARGETS libraries HEADERS directory [PRIVATE libraries]): installs the
# libraries with pkg-config file and CMake package; all of it may be moved together.
function(c_package name)
    cmake_parse_arguments(ARG "" "PC;COMPONENT;DESCRIPTION;HEADERS;PRIVATE" "TARGETS" ${ARGN})
    set(package ${CMAKE_INSTALL_LIBDIR}/cmake/${name})
    file(RELATIVE_PATH PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    configure_file(cmake/library.pc.in ${CMAKE_BINARY_DIR}/${ARG_PC}.pc @ONLY)
    configure_file(cmake/Config.cmake.in ${CMAKE_BINARY_DIR}/${name}Config.cmake @ONLY)
    write_basic_package_version_file(${CMAKE_BINARY_DIR}/${name}ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
    install(TARGETS ${ARG_TARGETS} EXPORT ${name} COMPONENT ${ARG_COMPONENT})
    install(DIRECTORY ${ARG_HEADERS}/stiffaxis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${ARG_COMPONENT})
    install(FILES ${CMAKE_BINARY_DIR}/${ARG_PC}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${ARG_COMPONENT})
    install(EXPORT ${name} NAMESPACE stiffaxis:: DESTINATION ${package} COMPONENT ${ARG_COMPONENT})
    install(FILES ${CMAKE_BINARY_DIR}/${name}Config.cmake ${CMAKE_BINARY_DIR}/${name}ConfigVersion.cmake
        DESTINATION ${package} COMPONENT ${ARG_COMPONENT})
endfunction()
