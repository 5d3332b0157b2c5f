#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the wheel without a network, installs it into a virtual environment of a bare Debian that has numpy, and runs the examples there.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
root=$(readlink -f "$here/../..")

if [ "${1:-}" != inside ]; then
    cd "$root"
    for package in python3-build python3-wheel python3-setuptools pybind11-dev python3-dev patchelf; do
        dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -q '^installed$' || { echo "skipped: $package is not installed"; exit 77; }
    done
    rm -rf dist
    /usr/bin/python3 -m build --no-isolation --wheel >build/wheel.log 2>&1 || { tail -n 30 build/wheel.log >&2; exit 1; }
    wheels=(dist/rakelight-*-manylinux_*.whl)
    /usr/bin/python3 tools/package/repair_wheel.py --check "${wheels[0]}"
    ls -l "${wheels[0]}"
    exec "$here/bare_debian.sh" --give "${wheels[0]}" --give python/examples --give data/spot/spot_slab5.glb "$0" inside
fi

apt-get update >/dev/null
apt-get install python3-numpy python3-venv >/dev/null
python3 -m venv --system-site-packages environment
environment/bin/pip install --no-index "$GIVEN"/rakelight-*.whl
python=environment/bin/python
examples=$GIVEN/examples

# The helper: X is read by it alone.
printf 'xof 0303txt 0032\nMesh a {\n3;\n0.0;0.0;0.0;,\n1.0;0.0;0.0;,\n0.0;1.0;0.0;;\n1;\n3;0,1,2;;\n}\n' >triangle.x
$python - <<'TEXT'
import rakelight
print(rakelight.build_info())
print(rakelight.load("triangle.x"))
assert rakelight.render("builtin:teapot", resolution=(64, 48))["image"].std() > 10
TEXT

$python "$examples/dataset.py" builtin:teapot views --views 20 --size 128
[ "$(ls views/*.npz | wc -l)" = 20 ]
$python "$examples/seam_gate.py" "$GIVEN/spot_slab5.glb" --repair fixed && { echo "the seams were not found" >&2; exit 1; }
$python "$examples/seam_gate.py" fixed/spot_slab5.glb
$python "$examples/training_arrays.py" "$GIVEN/spot_slab5.glb" builtin:teapot
[ -s arrays/spot_slab5.npz ]
environment/bin/pip uninstall -y rakelight
[ -z "$(find environment -path '*rakelight*')" ]
echo "the wheel works in a bare Debian"
