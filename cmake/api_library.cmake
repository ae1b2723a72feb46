# libstiffaxis: cases, sections and rods for other programs and for Python (api/stiffaxis.h). It keeps libstiffaxis_base, and the
# modules beside that, in the folder of its own that the program has them in.
include(cmake/c_library.cmake)

function(api_library)
    set(headers ${CMAKE_BINARY_DIR}/include_api)
    configure_file(api/stiffaxis.h ${headers}/stiffaxis/stiffaxis.h COPYONLY)
    file(GLOB sources CONFIGURE_DEPENDS api/*.c)
    add_library(stiffaxis_api SHARED ${sources})
    our_code(stiffaxis_api)
    set_target_properties(stiffaxis_api PROPERTIES EXPORT_NAME stiffaxis C_VISIBILITY_PRESET hidden)
    abi(stiffaxis_api stiffaxis)
    # rooms without which a case can be read and a rod solved stay out
    target_link_options(stiffaxis_api PRIVATE -Wl,--as-needed)
    target_link_libraries(stiffaxis_api PRIVATE commands)
    target_include_directories(stiffaxis_api INTERFACE $<BUILD_INTERFACE:${headers}>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    file(RELATIVE_PATH modules /${CMAKE_INSTALL_LIBDIR} /${MODULES})
    set_target_properties(stiffaxis_api PROPERTIES INSTALL_RPATH "$ORIGIN:$ORIGIN/${modules}")
    add_dependencies(stiffaxis_api door_gmsh)
    c_package(stiffaxis PC stiffaxis COMPONENT api DESCRIPTION "cross sections, stiffness and rods of multi-material soft robots"
        TARGETS stiffaxis_api HEADERS ${headers})
    set_property(GLOBAL APPEND PROPERTY c_libraries stiffaxis_api)
    # for pip, or for PYTHONPATH; it finds the library from there
    install(DIRECTORY python/ DESTINATION ${CMAKE_INSTALL_DATADIR}/stiffaxis/python COMPONENT python
        PATTERN "__pycache__" EXCLUDE PATTERN "*.egg-info" EXCLUDE PATTERN build EXCLUDE)
endfunction()
