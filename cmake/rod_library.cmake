# The rod solver as a C library of its own: libstiffaxis_rod.so and .a, headers, pkg-config file and CMake package.
include(cmake/c_library.cmake)

# what <stiffaxis/rod.h> needs; in order, each after what it includes
set(ROD_HEADERS base/status.h base/mark.h base/field.h base/dense.h base/se3.h base/beam_law.h base/law_along.h
    rodsolver/rod.h)

# Outside, the rooms lie below stiffaxis/: one include directory that is in everybody's way already.
function(rod_headers destination)
    foreach(header ${ROD_HEADERS})
        file(READ ${PROJECT_SOURCE_DIR}/${header} text)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
        string(REGEX REPLACE "#include \"(base|rodsolver)/" "#include \"stiffaxis/\\1/" text "${text}")
        file(CONFIGURE OUTPUT ${destination}/stiffaxis/${header} CONTENT "${text}" @ONLY)
    endforeach()
    configure_file(cmake/rod.h.in ${destination}/stiffaxis/rod.h @ONLY)
endfunction()

function(rod_library)
    set(headers ${CMAKE_BINARY_DIR}/include)
    rod_headers(${headers})
    add_library(stiffaxis_rod SHARED $<TARGET_OBJECTS:rodsolver> $<TARGET_OBJECTS:base>)
    add_library(stiffaxis_rod_static STATIC $<TARGET_OBJECTS:rodsolver> $<TARGET_OBJECTS:base>)
    abi(stiffaxis_rod stiffaxis_rod)
    set_target_properties(stiffaxis_rod PROPERTIES EXPORT_NAME rod INSTALL_RPATH "")
    set_target_properties(stiffaxis_rod_static PROPERTIES EXPORT_NAME rod_static LINKER_LANGUAGE C
        OUTPUT_NAME stiffaxis_rod ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
    set_property(GLOBAL APPEND PROPERTY c_libraries stiffaxis_rod stiffaxis_rod_static)
    foreach(library stiffaxis_rod stiffaxis_rod_static)
        target_link_libraries(${library} PRIVATE m)
        target_include_directories(${library} INTERFACE $<BUILD_INTERFACE:${headers}>
            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    endforeach()
    c_package(stiffaxis_rod PC stiffaxis-rod COMPONENT rod DESCRIPTION "shapes of tendon-driven rods under any load"
        TARGETS stiffaxis_rod stiffaxis_rod_static HEADERS ${headers} PRIVATE "-lm -pthread")

    file(GLOB files CONFIGURE_DEPENDS examples/*.c)
    foreach(file ${files})
        get_filename_component(name ${file} NAME_WE)
        add_executable(${name} ${file})
        target_compile_definitions(${name} PRIVATE _POSIX_C_SOURCE=200809L)
        target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Werror)
        target_link_libraries(${name} PRIVATE stiffaxis_rod m)
    endforeach()
endfunction()
