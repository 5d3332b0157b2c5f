// SPDX-License-Identifier: Apache-2.0
// A program of its own because precompiled headers belong to one: see CMakeLists.txt.
int main() {}
