#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The step of the action: MODELS (a pattern a line), LIMITS, REPORT, PAGE and PROGRAM come by the environment, so that no value is read as
# shell text. Errors are shown beside the run, the exit code is that of the program.
set -uo pipefail
shopt -s globstar nullglob

models=()
while IFS= read -r pattern; do
    [ -n "$pattern" ] || continue
    IFS=''
    found=($pattern)  # finds files; blanks in the pattern do not split it
    unset IFS
    [ ${#found[@]} -gt 0 ] || { echo "::error title=rakelight::no model matches '$pattern'"; echo "exit-code=3" >>"$GITHUB_OUTPUT"; exit 3; }
    models+=("${found[@]}")
done <<<"$MODELS"
read -ra limits <<<"$LIMITS"
reports=(--report "$REPORT")
[ -z "$PAGE" ] || reports+=(--report "$PAGE")

"$PROGRAM" inspect --check "${limits[@]}" "${reports[@]}" -- "${models[@]}" 2> >(sed 's/^rakelight: error: /::error title=rakelight::/; s/^rakelight: warning: /::warning title=rakelight::/')
code=$?
wait
echo "exit-code=$code" >>"$GITHUB_OUTPUT"
exit "$code"
