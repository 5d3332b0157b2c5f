#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# In the changed root of toolchain.sh: puts headers and libraries into emscripten's sysroot, where CMake looks for them.
#
#   libraries.sh "HEADERS OF DEBIAN 13" "HEADERS OF DEBIAN 12" "SOURCES OF DEBIAN 12"
set -euo pipefail
sysroot=/usr/share/emscripten/cache/sysroot
mkdir -p /tmp/libraries "$sysroot/share/cmake" "$sysroot/lib/pkgconfig"
cd /tmp/libraries

for package in $1; do apt-get download "$package"; done
for package in $2; do apt-get download "$package/bookworm"; done
for file in *.deb; do dpkg -x "$file" unpacked; done
cp -R unpacked/usr/include/. "$sysroot/include/"
cp -R unpacked/usr/share/cmake/. "$sysroot/share/cmake/"

for package in $3; do apt-get source "$package/bookworm"; done
compile() { emcc -O2 -fwasm-exceptions -I "$sysroot/include" "$@"; }

(
    cd zlib-*/
    cp zlib.h zconf.h "$sysroot/include/"
    for name in adler32 compress crc32 deflate gzclose gzlib gzread gzwrite infback inffast inflate inftrees trees uncompr zutil; do
        compile -DHAVE_UNISTD_H -c $name.c -o $name.o
    done
    emar rcs "$sysroot/lib/libz.a" ./*.o
)
(
    cd libspng-*/spng
    cp spng.h "$sysroot/include/"
    compile -c spng.c -o spng.o
    emar rcs "$sysroot/lib/libspng.a" spng.o
    printf '%s\n' 'Name: spng' 'Description: PNG' "Version: $(basename "$(dirname "$PWD")" | sed 's/.*-//')" \
        "Libs: -L$sysroot/lib -lspng -lz" "Cflags: -I$sysroot/include" >"$sysroot/lib/pkgconfig/spng.pc"
)
(
    mkdir jpeg && cd jpeg
    emcmake cmake -G Ninja ../libjpeg-turbo-*/ -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS=-fwasm-exceptions -DWITH_SIMD=0 \
        -DENABLE_SHARED=0 -DWITH_TURBOJPEG=0
    ninja jpeg-static
    cp libjpeg.a "$sysroot/lib/"
    cp jconfig.h ../libjpeg-turbo-*/jpeglib.h ../libjpeg-turbo-*/jmorecfg.h ../libjpeg-turbo-*/jerror.h "$sysroot/include/"
)
cd /
rm -rf /tmp/libraries
