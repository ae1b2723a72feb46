# Rows of tests/data/messages.txt -> a directory with a case and a command for each: work/N/case.yaml, work/N/command, and
# work/N/wanted with the exit code and the message.
#
#   case OLD => NEW    the base case with its first OLD replaced, \n for line ends and \t for tabs: check case.yaml
#   text TEXT          this case
#   run WORDS          the program with these words, beside the base case
#   CODE MESSAGE       what is answered, the line after each of them
function lines(text) { gsub(/\\n/, "\n", text); gsub(/\\t/, "\t", text); return text }
FNR == NR { base = base $0 "\n"; next }
/^$/ || /^#/ { next }
/^(case|text|run) / {
    n++
    folder = work "/" n
    system("mkdir -p " folder)
    rest = substr($0, index($0, " ") + 1)
    text = base
    command = "check case.yaml"
    if ($1 == "case") {
        cut = index(rest, " => ")
        old = lines(substr(rest, 1, cut - 1))
        at = index(base, old)
        if (!cut || !at) { print "no such place: " rest; exit 1 }
        text = substr(base, 1, at - 1) lines(substr(rest, cut + 4)) substr(base, at + length(old))
    } else if ($1 == "text") text = lines(rest)
    else command = rest
    printf "%s", text > (folder "/case.yaml")
    print command > (folder "/command")
    close(folder "/case.yaml"); close(folder "/command")
    next
}
{ print > (folder "/wanted"); close(folder "/wanted") }
