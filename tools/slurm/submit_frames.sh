#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# A sequence as a Slurm job array: each task renders a range of frames, and a job that depends on all of them may follow.
#
#   submit_frames.sh --frames FIRST:LAST --chunk N [--then COMMAND] [--logs FOLDER] [--sbatch OPTIONS] [--then-sbatch OPTIONS]
#                    -- rakelight render MODEL --frames {first}:{last} [OPTION...]
#
# In the command {first} and {last} stand for a task's first and last frame, whatever option takes the range. With --skip-existing in
# it, a task that runs again goes on where it was. COMMAND is a line for the shell, such as an encoder of films. OPTIONS are words
# for sbatch. Prints the numbers of the jobs.
set -euo pipefail

fail() { echo "submit_frames.sh: $1" >&2; exit 2; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
frames='' chunk='' after='' logs=. array_options='' after_options=''
while [ $# -gt 0 ]; do
    case $1 in
        --) shift; break ;;
        --frames|--chunk|--then|--logs|--sbatch|--then-sbatch) [ $# -ge 2 ] || fail "$1 needs a value" ;;
        *) fail "unknown option '$1'; the command stands behind --" ;;
    esac
    case $1 in
        --frames) frames=$2 ;;
        --chunk) chunk=$2 ;;
        --then) after=$2 ;;
        --logs) logs=$2 ;;
        --sbatch) array_options=$2 ;;
        --then-sbatch) after_options=$2 ;;
    esac
    shift 2
done

[[ $frames =~ ^([0-9]{1,9}):([0-9]{1,9})$ ]] || fail "--frames FIRST:LAST is missing or no range"
first=$((10#${BASH_REMATCH[1]})) last=$((10#${BASH_REMATCH[2]}))
[ "$first" -le "$last" ] || fail "the last frame comes before the first"
[[ $chunk =~ ^[1-9][0-9]{0,8}$ ]] || fail "--chunk N, the frames of a task, is missing or no number"
[ $# -gt 0 ] || fail "the command behind -- is missing"
[[ "$*" == *'{first}'* && "$*" == *'{last}'* ]] || fail "the command does not say where {first} and {last} go"
mkdir -p "$logs"

tasks=$(((last - first) / chunk + 1))
# shellcheck disable=SC2086  # options are words
array=$(sbatch --parsable --requeue --array="0-$((tasks - 1))" --job-name=rakelight-frames --output="$logs/frames-%a.log" \
    --open-mode=append $array_options "$here/frames.sbatch" "$first" "$last" "$chunk" "$@")
array=${array%%;*}
# On each task: afterok on the whole array never comes true once a task has failed, although its next try was fine.
every=$(seq -f "${array}_%.0f" -s : 0 "$((tasks - 1))")
[ -n "$after" ] || { echo "array $array"; exit; }
# shellcheck disable=SC2086
then=$(sbatch --parsable --dependency="afterok:$every" --kill-on-invalid-dep=yes --job-name=rakelight-then \
    --output="$logs/then.log" $after_options --wrap "$after")
echo "array $array then ${then%%;*}"
