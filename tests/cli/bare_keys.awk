# Prints the keys of a case that no comment explains: neither one behind a key with a line to itself, nor one above that begins
# with the key's name. Knows no schema, only where keys stand; the names of materials are no keys.
{
    line = $0
    # texts in quotes hold neither keys nor comments
    gsub(/"[^"]*"/, "\"\"", line)
    gsub(/'[^' ]*'/, "''", line)
    comment = ""
    if (match(line, /(^| )#.*/)) {
        comment = substr(line, RSTART)
        line = substr(line, 1, RSTART - 1)
    }
    if (line ~ /^ *$/) {
        if (match(comment, /# [A-Za-z_0-9]+  /)) explained[substr(comment, RSTART + 2, RLENGTH - 4)] = 1
        next
    }
    if (line ~ /^[a-z]/) inside = line
    behind = comment != ""
    first = 1
    while (match(line, /[A-Za-z_][A-Za-z_0-9]*:( |$)/)) {
        word = substr(line, RSTART, RLENGTH)
        sub(/: *$/, "", word)
        before = substr(line, 1, RSTART - 1)
        line = substr(line, RSTART + RLENGTH - (RLENGTH > length(word) + 1))
        named = inside ~ /^materials:/ && first && before == "  "
        if (first && behind && before ~ /^[ -]*$/) explained[word] = 1
        first = 0
        keys++
        if (!named && !(word in explained)) {
            print NR ": " word
            explained[word] = 1
        }
    }
}
END { if (!keys) print "no keys" }
