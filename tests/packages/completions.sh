#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What bash, zsh and fish offer for the packages' program, where these shells are installed.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

compgen -G 'build/packages/*.deb' >/dev/null || { echo 'there are no packages: tools/package/make_packages.sh makes them' >&2; exit 1; }
python3 tests/cli/program/completion_test.py build/deb/rakelight
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
dpkg-deb -x build/packages/rakelight_*.deb "$place"
cmp <(build/deb/rakelight --completion bash) "$place/usr/share/bash-completion/completions/rakelight"
cmp <(build/deb/rakelight --completion zsh) "$place/usr/share/zsh/vendor-completions/_rakelight"
cmp <(build/deb/rakelight --completion fish) "$place/usr/share/fish/vendor_completions.d/rakelight.fish"
