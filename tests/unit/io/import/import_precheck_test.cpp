// SPDX-License-Identifier: Apache-2.0
// What the look before the import refuses, and what it lets pass.
#include <gtest/gtest.h>

#include <cstring>

#include "io/import/precheck.h"

namespace rakelight::io {
namespace {

struct Verdict {
    std::string error;
    std::size_t warnings = 0;
};

Verdict check(const std::string& ending, const std::string& bytes) {
    Report report;
    Verdict verdict;
    try {
        check_before_import(ending, {std::as_bytes(std::span(bytes)), "file", report});
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::bad_file);
        verdict.error = e.what();
    }
    for (const ReportEntry& e : report.entries()) verdict.warnings += e.remark == Remark::warning;
    return verdict;
}

template <class T>
std::string raw(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

TEST(ImportPrecheck, EmptyFilesAndUnknownEndingsAreRefused) {
    for (const char* ending : {"3ds", "ase", "blend", "dae", "fbx", "x"})
        EXPECT_NE(check(ending, "").error, "") << ending;
    EXPECT_NE(check("txt", "text").error, "");
}

TEST(ImportPrecheck, EveryPrefixOfGarbageIsRefusedWithoutACrash) {
    std::string noise;
    std::uint32_t state = 1;
    for (int i = 0; i < 300; ++i) noise += char((state = state * 1664525u + 1013904223u) >> 24);
    for (const char* ending : {"3ds", "ase", "blend", "dae", "fbx", "x"})
        for (std::size_t size = 0; size <= noise.size(); ++size)
            EXPECT_NE(check(ending, noise.substr(0, size)).error, "") << ending << " " << size;
}

TEST(ImportPrecheck, CountsOfAnAseAreHeldAgainstItsSize) {
    const std::string head = "*3DSMAX_ASCIIEXPORT 200\n*COMMENT \"\n *MESH_NUMVERTEX x\"\n*MESH {\n\t*MESH_NUMVERTEX ";
    EXPECT_EQ(check("ase", head + "8\n}\n").error, "");
    EXPECT_EQ(check("ase", head + "2147483648\n}\n").error,
              "line 5: *MESH_NUMVERTEX promises 2147483648 entries, but the file has 93 bytes");
    EXPECT_NE(check("ase", head + "99999999999999999999999\n}\n").error, "");
    EXPECT_EQ(check("ase", "*3DSMAX_ASCIIEXPORT 200\n*COMMENT \"a *MESH_NUMVERTEX 2147483648\"\n").error, "");
    EXPECT_EQ(check("ase", "*3DSMAX_ASCIIEXPORT 2147483648\n*MESH_NUMVERTEX").error, "");
    EXPECT_NE(check("ase", "*MATERIAL_COUNT 2147483648").error, "");
}

TEST(ImportPrecheck, BlocksOf3dsStayInsideOneAnother) {
    const auto block = [](std::uint16_t id, const std::string& inside) {
        return raw(id) + raw(std::uint32_t(6 + inside.size())) + inside;
    };
    const std::string mesh = block(0x4100, block(0x4110, raw(std::uint16_t(1)) + std::string(12, '\0')));
    const std::string whole = block(0x4D4D, block(0x3D3D, block(0x4000, std::string("cube\0", 5) + mesh)));
    EXPECT_EQ(check("3ds", whole).error, "");
    EXPECT_NE(check("3ds", whole.substr(0, whole.size() - 1)).error, "");
    EXPECT_EQ(check("3ds", whole + "x").warnings, 1u);
    EXPECT_NE(check("3ds", block(0x4D4D, raw(std::uint16_t(0x3D3D)) + raw(std::uint32_t(100)))).error, "");
    EXPECT_NE(check("3ds", block(0x4D4D, raw(std::uint16_t(0x3D3D)) + raw(std::uint32_t(0)))).error, "");
    EXPECT_NE(check("3ds", block(0x4D4D, block(0x3D3D, block(0x4000, "no end of name")))).error, "");
}

TEST(ImportPrecheck, BlendFilesReachTheirLastBlock) {
    const auto block = [](const char* code, std::uint32_t bytes) {
        return std::string(code, 4) + raw(bytes) + std::string(12, '\0') + std::string(bytes, 'x');
    };
    const std::string head = "BLENDER_v248", whole = head + block("DNA1", 8) + block("ENDB", 0);
    EXPECT_EQ(check("blend", whole).error, "");
    EXPECT_NE(check("blend", head + block("DNA1", 8)).error, "");
    EXPECT_NE(check("blend", head + block("ENDB", 0)).error, "");
    EXPECT_NE(check("blend", whole.substr(0, 30)).error, "");
    EXPECT_NE(check("blend", std::string("\x28\xb5\x2f\xfd", 4) + std::string(40, 'x')).error, "");
}

TEST(ImportPrecheck, AColladaEncodingMayEndAnywhere) {
    const std::string no_utf8 = "<COLLADA>\xC3\x28</COLLADA>";
    for (std::size_t blanks = 150; blanks < 200; ++blanks) {  // over the end of what is looked at
        const std::string head = "<?xml version=\"1.0\"" + std::string(blanks, ' ');
        EXPECT_EQ(check("dae", head + "encoding=\"latin-1\"?>" + no_utf8).error, "") << blanks;
        EXPECT_NE(check("dae", head + "encoding=\"utf-8\"?>" + no_utf8).error, "") << blanks;
        EXPECT_NE(check("dae", head + "encoding='UTF-8'?>" + no_utf8).error, "") << blanks;
        EXPECT_NE(check("dae", head + "encoding=").error, "") << blanks;
        EXPECT_NE(check("dae", head + "encoding=\"").error, "") << blanks;
    }
}

TEST(ImportPrecheck, IndicesOfAColladaAreWholeNumbers) {
    EXPECT_EQ(check("dae", "<COLLADA>\n<p>0 1 -1\n+2\t3 </p><p></p><p/><q>1.5</q></COLLADA>").error, "");
    EXPECT_EQ(check("dae", "<COLLADA>\n<p>0 1\n 1.5 2</p></COLLADA>").error,
              "line 3: the indices <p> hold '1.5', which is not a whole number");
    EXPECT_NE(check("dae", "<COLLADA><p count=\"3\">x</p></COLLADA>").error, "");
}

TEST(ImportPrecheck, AColladaFileMayBeUtf16AndWordsMayGoOnBetweenParts) {
    const std::string text = "<COLLADA><p>0 1 2</p></COLLADA>";
    std::string wide = "\xFF\xFE";
    for (const char c : text) wide += std::string{c, '\0'};
    EXPECT_EQ(check("dae", wide).error, "");
    EXPECT_NE(check("dae", wide.substr(0, wide.size() - 8)).error, "");
    std::string digits = "<COLLADA>\n<p>";
    for (int i = 0; i < 400'000; ++i) digits += "12345\n";
    EXPECT_EQ(check("dae", digits + "</p></COLLADA>").error, "");
    EXPECT_NE(check("dae", digits + "12.5</p></COLLADA>").error.find("line 400002: the indices <p> hold '12.5'"),
              std::string::npos);
}

TEST(ImportPrecheck, ColladaHasNoEntitiesAndEndsWhereItBegan) {
    const std::string good = "<?xml version=\"1.0\"?>\n<COLLADA a=\"1 > 0\"><!-- <x> --><asset/></COLLADA>\n";
    EXPECT_EQ(check("dae", good).error, "");
    EXPECT_NE(check("dae", "<!DOCTYPE foo [<!ENTITY x SYSTEM \"file:///etc/hostname\">]>" + good).error, "");
    EXPECT_NE(check("dae", good.substr(0, good.size() - 4)).error, "");
    EXPECT_NE(check("dae", "<COLLADA><a></b></COLLADA>").error, "");
    EXPECT_NE(check("dae", "<COLLADA>\xC3\x28</COLLADA>").error, "");
    EXPECT_NE(check("dae", "<COLLADA>\x01</COLLADA>").error, "");
    EXPECT_NE(check("dae", "no markup at all").error, "");
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "<a>";
    EXPECT_NE(check("dae", deep).error, "");
}

TEST(ImportPrecheck, FbxNodesStayInsideOneAnother) {
    const std::string magic("Kaydara FBX Binary  \0\x1a\0", 23), end(13, '\0');
    const auto node = [](std::uint32_t node_end, std::uint32_t bytes) {
        return raw(node_end) + raw(std::uint32_t(0)) + raw(bytes) + raw(std::uint8_t(1)) + "N" +
               std::string(bytes, 'p');
    };
    const std::string whole = magic + raw(7400u) + node(27 + 13 + 1 + 5, 5) + end;
    EXPECT_EQ(check("fbx", whole).error, "");
    EXPECT_NE(check("fbx", whole.substr(0, whole.size() - 1)).error, "");
    EXPECT_NE(check("fbx", magic + raw(7400u) + node(10000, 5) + end).error, "");
    EXPECT_NE(check("fbx", magic + raw(7400u) + node(1, 5) + end).error, "");
    EXPECT_NE(check("fbx", magic + raw(6100u) + node(46, 5) + end).error.find("6100"), std::string::npos);
    EXPECT_NE(check("fbx", "; FBX 7.3.0 project file\nObjects: {\n").error, "");
    EXPECT_EQ(check("fbx", "; FBX 7.3.0 project file\nObjects: {\n name: \"}\"\n}\n").error, "");
}

TEST(ImportPrecheck, OpenBracesAreCounted) {
    const auto open = [](std::string_view text) { return open_braces(std::as_bytes(std::span(text))); };
    EXPECT_EQ(open(""), 0);
    EXPECT_EQ(open("{ { }"), 1);
    EXPECT_EQ(open("{ \"}\" }"), 0);
    EXPECT_EQ(open("}{"), -1);
    EXPECT_EQ(open("\"unclosed {\n}"), -1);
    EXPECT_EQ(open(std::string_view("{\0}\0", 4)), 0);
}

}  // namespace
}  // namespace rakelight::io
