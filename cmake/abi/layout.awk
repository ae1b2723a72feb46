# Headers in, a C program out that tells how large the structs of these headers are, where their members lie and what their
# constants are: awk -f layout.awk HEADER... A member that this does not see the compiler's sizes still tell of.
BEGIN {
    print "#include <stddef.h>\n#include <stdio.h>\n#define MEMBER(s, m) printf(\"    %-20s %4zu %4zu\\n\", #m, offsetof(s, m), sizeof(((s *)0)->m))"
    body = ""
}
{ sub(/\/\/.*/, "") }
/^typedef struct [a-z0-9_]+ \{/ {
    name = $3
    inside = "struct"
    text = ""
    body = body sprintf("    printf(\"%%s %%zu\\n\", \"%s\", sizeof(%s));\n", name, name)
    next
}
/^(typedef )?enum/ { inside = "enum"; text = $0; sub(/^[^{]*\{?/, "", text) }
inside == "enum" && !/^(typedef )?enum/ { text = text " " $0 }
inside == "enum" && /\}/ {
    sub(/\}.*/, "", text)
    count = split(text, part, ",")
    for (i = 1; i <= count; i++)
        if (match(part[i], /[A-Z][A-Z0-9_]*/))
            body = body sprintf("    printf(\"%%s = %%d\\n\", \"%s\", (int)%s);\n", substr(part[i], RSTART, RLENGTH), substr(part[i], RSTART, RLENGTH))
    inside = ""
}
inside == "struct" && /^\}/ {
    count = split(text, member, ";")
    for (i = 1; i <= count; i++) {
        line = member[i]
        if (match(line, /\(\*[a-z0-9_]+\)/)) # a function
            line = "f " substr(line, RSTART + 2, RLENGTH - 3)
        gsub(/\[[^]]*\]/, "", line)
        gsub(/\*/, " ", line)
        parts = split(line, part, ",")
        for (k = 1; k <= parts; k++) {
            words = split(part[k], word, /[ \t]+/)
            while (words > 0 && word[words] == "") words--
            if (words > 0) body = body sprintf("    MEMBER(%s, %s);\n", name, word[words])
        }
    }
    inside = ""
}
inside == "struct" { text = text " " $0 }
END { printf "int main(void)\n{\n%s    return 0;\n}\n", body }
