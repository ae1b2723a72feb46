# The rod solver as a C library of its own: libstiffaxis_rod.so and .a, headers, pkg-config file and CMake package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# what <stiffaxis/rod.h> needs; in order, each after what it includes
set(ROD_HEADERS base/status.h base/mark.h base/field.h base/dense.h base/se3.h base/beam_law.h base/law_along.h
    rodsolver/rod.h)

# Outside, the rooms lie below stiffaxis/: one include directory that is in everybody's way already.
function(rod_headers destination names)
    set(found)
    foreach(header ${ROD_HEADERS})
        file(READ ${PROJECT_SOURCE_DIR}/${header} text)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
        # declarations begin at the margin; their names stand before the first parenthesis
        string(REGEX MATCHALL "\n[a-z][a-z0-9_ ]* \\*?[a-z0-9_]+\\(" declared "${text}")
        foreach(line ${declared})
            if(NOT line MATCHES "static|typedef")
                string(REGEX REPLACE ".*[ *]([a-z0-9_]+)\\($" "\\1" name "${line}")
                list(APPEND found ${name})
            endif()
        endforeach()
        string(REGEX REPLACE "#include \"(base|rodsolver)/" "#include \"stiffaxis/\\1/" text "${text}")
        file(CONFIGURE OUTPUT ${destination}/stiffaxis/${header} CONTENT "${text}" @ONLY)
    endforeach()
    configure_file(cmake/rod.h.in ${destination}/stiffaxis/rod.h @ONLY)
    set(${names} ${found} PARENT_SCOPE)
endfunction()

function(rod_library)
    set(headers ${CMAKE_BINARY_DIR}/include)
    rod_headers(${headers} names)
    list(JOIN names ";\n        " names)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/stiffaxis_rod.map CONTENT
        "STIFFAXIS_ROD_${PROJECT_VERSION_MAJOR} {\n    global:\n        ${names};\n    local:\n        *;\n};\n")

    add_library(stiffaxis_rod SHARED $<TARGET_OBJECTS:rodsolver> $<TARGET_OBJECTS:base>)
    add_library(stiffaxis_rod_static STATIC $<TARGET_OBJECTS:rodsolver> $<TARGET_OBJECTS:base>)
    set_target_properties(stiffaxis_rod PROPERTIES EXPORT_NAME rod LINKER_LANGUAGE C INSTALL_RPATH ""
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR} LINK_DEPENDS ${CMAKE_BINARY_DIR}/stiffaxis_rod.map)
    set_target_properties(stiffaxis_rod_static PROPERTIES EXPORT_NAME rod_static LINKER_LANGUAGE C
        OUTPUT_NAME stiffaxis_rod ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
    target_link_options(stiffaxis_rod PRIVATE -Wl,--version-script=${CMAKE_BINARY_DIR}/stiffaxis_rod.map
        -Wl,--gc-sections)
    set_property(GLOBAL APPEND PROPERTY c_libraries stiffaxis_rod stiffaxis_rod_static)
    foreach(library stiffaxis_rod stiffaxis_rod_static)
        target_link_libraries(${library} PRIVATE m)
        target_include_directories(${library} INTERFACE $<BUILD_INTERFACE:${headers}>
            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    endforeach()

    file(GLOB files CONFIGURE_DEPENDS examples/*.c)
    foreach(file ${files})
        get_filename_component(name ${file} NAME_WE)
        add_executable(${name} ${file})
        target_compile_definitions(${name} PRIVATE _POSIX_C_SOURCE=200809L)
        target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Werror)
        target_link_libraries(${name} PRIVATE stiffaxis_rod m)
    endforeach()

    set(package ${CMAKE_INSTALL_LIBDIR}/cmake/stiffaxis_rod)
    file(RELATIVE_PATH ROD_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    configure_file(cmake/stiffaxis-rod.pc.in ${CMAKE_BINARY_DIR}/stiffaxis-rod.pc @ONLY)
    configure_file(cmake/stiffaxis_rodConfig.cmake.in ${CMAKE_BINARY_DIR}/stiffaxis_rodConfig.cmake @ONLY)
    write_basic_package_version_file(${CMAKE_BINARY_DIR}/stiffaxis_rodConfigVersion.cmake
        COMPATIBILITY SameMinorVersion)
    install(TARGETS stiffaxis_rod stiffaxis_rod_static EXPORT stiffaxis_rod COMPONENT rod)
    install(DIRECTORY ${headers}/stiffaxis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT rod)
    install(FILES ${CMAKE_BINARY_DIR}/stiffaxis-rod.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT rod)
    install(EXPORT stiffaxis_rod NAMESPACE stiffaxis:: DESTINATION ${package} COMPONENT rod)
    install(FILES ${CMAKE_BINARY_DIR}/stiffaxis_rodConfig.cmake ${CMAKE_BINARY_DIR}/stiffaxis_rodConfigVersion.cmake
        DESTINATION ${package} COMPONENT rod)
endfunction()
