# The page's scripts inside the program: three.js as Debian ships it, and reports/view.js. The assembler takes the bytes in;
# their SHA-256 is what the page's content-security policy lets run.
# Included: embed_scripts(room). As a script: cmake -DTHREE=three.min.js -DVIEW=view.js -DOUT=scripts.c -P scripts.cmake

if(CMAKE_SCRIPT_MODE_FILE)
    set(source "#include \"reports/scripts.h\"\n")
    foreach(name three view)
        string(TOUPPER ${name} upper)
        set(file "${${upper}}")
        file(SHA256 ${file} hash)
        string(REGEX REPLACE "(..)" "0x\\1, " hash ${hash})
        file(READ ${file} text)
        # what the browser's parser would change, the hash would not know of
        if(text MATCHES "\r|</script|<!--")
            message(FATAL_ERROR "${file} cannot stand in a page as it is: a carriage return, </script or <!-- in it")
        endif()
        string(APPEND source "
__asm__(\".pushsection .rodata\\n\"
        \".global stiffaxis_${name}\\n\"
        \".global stiffaxis_${name}_end\\n\"
        \"stiffaxis_${name}: .incbin \\\"${file}\\\"\\n\"
        \"stiffaxis_${name}_end: .byte 0\\n\"
        \".popsection\\n\");
extern const char stiffaxis_${name}[], stiffaxis_${name}_end[];
const script script_${name} = {stiffaxis_${name}, stiffaxis_${name}_end, {${hash}}};
")
    endforeach()
    file(WRITE ${OUT} "${source}")
    return()
endif()

set(SCRIPTS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(embed_scripts room)
    find_file(THREE_JS three.min.js PATHS /usr/share/javascript/three PATH_SUFFIXES build NO_DEFAULT_PATH)
    if(NOT THREE_JS)
        message(FATAL_ERROR "three.min.js is not there: install Debian's libjs-three (all packages stand in packages.txt), "
            "or give its place with -DTHREE_JS=FILE")
    endif()
    set(out ${CMAKE_BINARY_DIR}/scripts.c)
    set(view ${PROJECT_SOURCE_DIR}/reports/view.js)
    add_custom_command(OUTPUT ${out}
        COMMAND ${CMAKE_COMMAND} -DTHREE=${THREE_JS} -DVIEW=${view} -DOUT=${out} -P ${SCRIPTS_SCRIPT}
        DEPENDS ${THREE_JS} ${view} ${SCRIPTS_SCRIPT} VERBATIM COMMENT "the page's scripts")
    set_source_files_properties(${out} PROPERTIES OBJECT_DEPENDS "${THREE_JS};${view}")
    target_sources(${room} PRIVATE ${out})
endfunction()
