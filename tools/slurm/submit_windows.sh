#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# One very large picture as a Slurm job array: each task renders a window, and a job that depends on all of them joins the windows.
#
#   submit_windows.sh --resolution W,H --grid COLUMNSxROWS -o PICTURE [--parts FOLDER] [--resume] [--sbatch OPTIONS]
#                     [--join-sbatch OPTIONS] -- rakelight render MODEL [OPTION...]
#
# The command has no --resolution, --window and -o: each task adds its own. The parts go to FOLDER (PICTURE without its ending,
# and "-parts"); --resume renders the missing ones of a folder that has some. OPTIONS are words for sbatch, of the array and of
# the join. Prints the numbers of the two jobs.
set -euo pipefail

fail() { echo "submit_windows.sh: $1" >&2; exit 2; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
resolution='' grid='' picture='' parts='' resume='' array_options='' join_options=''
while [ $# -gt 0 ]; do
    case $1 in
        --) shift; break ;;
        --resume) resume=yes; shift; continue ;;
        --resolution|--grid|-o|--parts|--sbatch|--join-sbatch) [ $# -ge 2 ] || fail "$1 needs a value" ;;
        *) fail "unknown option '$1'; the command stands behind --" ;;
    esac
    case $1 in
        --resolution) resolution=$2 ;;
        --grid) grid=$2 ;;
        -o) picture=$2 ;;
        --parts) parts=$2 ;;
        --sbatch) array_options=$2 ;;
        --join-sbatch) join_options=$2 ;;
    esac
    shift 2
done

[[ $resolution =~ ^([1-9][0-9]{0,4})[,x]([1-9][0-9]{0,4})$ ]] || fail "--resolution W,H is missing or no size"
width=${BASH_REMATCH[1]} height=${BASH_REMATCH[2]}
[[ $grid =~ ^([1-9][0-9]{0,4})x([1-9][0-9]{0,4})$ ]] || fail "--grid COLUMNSxROWS is missing or no grid"
columns=${BASH_REMATCH[1]} rows=${BASH_REMATCH[2]}
((columns <= width && rows <= height)) || fail "the grid has more windows than the picture has pixels"
[[ $picture =~ \.(png|exr|hdr)$ ]] || fail "-o PICTURE is missing, or is no .png, .exr or .hdr"
program=()  # the words before the verb: containers and wrappers may start the program
for word in "$@"; do
    [ "$word" != render ] || break
    program+=("$word")
done
((${#program[@]} > 0 && ${#program[@]} < $#)) || fail "behind -- belongs a command with the verb render"
ending=${picture##*.}
parts=${parts:-${picture%.*}-parts}
mkdir -p "$parts"
[ -n "$resume" ] || [ -z "$(ls "$parts")" ] || fail "'$parts' has files: remove them, or render what is missing with --resume"

# shellcheck disable=SC2086  # options are words
array=$(sbatch --parsable --requeue --array="0-$((columns * rows - 1))" --job-name=rakelight-windows --output="$parts/%a.log" \
    --open-mode=append $array_options "$here/window.sbatch" "$columns" "$rows" "$width" "$height" "$parts" "$ending" "$@")
array=${array%%;*}
# On each task: afterok on the whole array never comes true once a task has failed, although its next try was fine.
every=$(seq -f "${array}_%.0f" -s : 0 "$((columns * rows - 1))")
# shellcheck disable=SC2086
join=$(sbatch --parsable --dependency="afterok:$every" --kill-on-invalid-dep=yes --job-name=rakelight-join --output="$parts/join.log" \
    $join_options "$here/join.sbatch" "$width,$height" "$parts" "$picture" "${program[@]}")
echo "array $array join ${join%%;*}"
