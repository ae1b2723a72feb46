#!/bin/sh
# Published tables in `compare`: what a case states is held, with exit code 1 outside of it.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

# the other programs that comparisons ask have tests of their own; here they are not installed
alone() {
    env PATH="$work/nothing" "$program" "$@"
}
for file in "$source"/cases/*.yaml; do
    grep -q '^  reference:' "$file" || continue
    expect 0 alone compare "$file"
    out 'against the published'
done

s1=$source/cases/becas_s1.yaml
expect 1 alone compare "$s1" --set section.reference.tolerance=1e-6
err 'K[nx,nx], ours (full) against the published'
expect 1 alone compare "$s1" --set 'section.reference.K=[[4, 3, 1e-4]]' # on sqrt(K44 K33)
err '3.46e-03'
expect 2 "$program" check "$s1" --set 'section.reference.K=[[0, 1, 2]]'
err 'entry 1 of reference.K: 0 is no row or column of a 6x6'
expect 2 "$program" check "$s1" --set 'section.reference.K=[[1, 2.5, 2]]'
err 'entry 1 of reference.K: 2.5 is no row or column of a 6x6'
finish
