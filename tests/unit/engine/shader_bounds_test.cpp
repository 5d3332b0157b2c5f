// SPDX-License-Identifier: Apache-2.0
// Bounds on what GLSL texts ask of a driver's compiler, counted in the text.
#include <gtest/gtest.h>

#include <rakelight/base/error.h>

#include "engines/shader_arrays.h"
#include "engines/shader_constants.h"
#include "engines/shader_macros.h"
#include "engines/shader_text.h"
#include "engines/shader_tokens.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

/// The tokens, with blanks between them.
std::string expanded(const std::string& text) {
    const std::string code = without_comments("a.glsl", text);
    const ShaderTokens tokens = shader_tokens("a.glsl", code);
    std::string out;
    const ExpandedShader all = expanded_macros("a.glsl", tokens);
    for (const ShaderToken& token : all.all) out += (out.empty() ? "" : " ") + std::string(token.text);
    return out;
}

Error refusal_of(const std::string& text) {
    return test::error_of([&] { parse_shader_text("a.glsl", text); });
}

void expect_refused(const std::string& text, const std::string& reason, const std::string& line) {
    const Error error = refusal_of(text);
    EXPECT_EQ(error.code(), ErrorCode::bad_file) << text.substr(0, 200);
    EXPECT_NE(error.reason().find(reason), std::string::npos) << error.what() << "\n" << text.substr(0, 200);
    EXPECT_EQ(error.place(), line) << error.what();
    EXPECT_EQ(error.file(), "a.glsl");
}

void expect_taken(const std::string& text) { EXPECT_NO_THROW(parse_shader_text("a.glsl", text)) << text; }

/// Each name stands for twice the one before.
std::string doubling(int steps, const std::string& last) {
    std::string text = "#define A0 " + last + "\n";
    for (int i = 1; i <= steps; ++i) {
        const std::string before = " A" + std::to_string(i - 1);
        text += "#define A" + std::to_string(i) + before + before + "\n";
    }
    return text;
}

TEST(ShaderMacros, AreExpandedAsThePreprocessorDoes) {
    EXPECT_EQ(expanded("#define N 4\nfloat a[N];"), "float a [ 4 ] ;");
    EXPECT_EQ(expanded("#define F(x, y) x + y\nF(1, (2, 3)) F"), "1 + ( 2 , 3 ) F");
    EXPECT_EQ(expanded("#define F (x)\nF"), "( x )") << "a blank before the bracket: no parameters";
    EXPECT_EQ(expanded("#define F(x) x x\n#define G F(1)\nF(G)"), "1 1 1 1");
    EXPECT_EQ(expanded("#define pow(x, y) pow(abs(x), y)\npow(pow(a, b), c)"),
              "pow ( abs ( pow ( abs ( a ) , b ) ) , c )")
        << "a name in its own expansion stays";
    EXPECT_EQ(expanded("#define A B\n#define B A 1\nA"), "A 1");
    EXPECT_EQ(expanded("#define F(x) 1 x\n#define G F\nG(2)"), "1 2") << "the bracket stands behind the expansion";
    EXPECT_EQ(expanded("#define CAT(a, b) a ## b\n#define xy 7\nCAT(x, y)"), "7");
    EXPECT_EQ(expanded("#define N 1\n#undef N\nN"), "N");
    EXPECT_EQ(expanded("#define N 1 \\\n 2\nN"), "1 2");
    EXPECT_EQ(expanded("#define N /* of\n lines */ 1\nN"), "1") << "a comment does not end a directive";
    EXPECT_EQ(expanded("RL_FN real f(RL_IN(vec3) v);"), "float f ( vec3 v ) ;") << "those of the prelude";
}

TEST(ShaderMacros, WhatAnIfLeavesOutIsNotThereAndWhatItMayLeaveOutIs) {
    EXPECT_EQ(expanded("#if 0\na\n#else\nb\n#endif\nc"), "b c");
    EXPECT_EQ(expanded("#ifndef N\n#define N 4\n#endif\nN"), "4");
    EXPECT_EQ(expanded("#define N 2\n#ifndef N\n#define N 4\n#endif\nN"), "2");
    EXPECT_EQ(expanded("#if defined(A)\na\n#elif 1\nb\n#else\nc\n#endif"), "b");
    EXPECT_EQ(expanded("#ifdef GL_ES\na\n#else\nb\n#endif"), "a b") << "the driver knows";
    EXPECT_EQ(expanded("#if 0\n#ifdef GL_ES\na\n#endif\n#endif\nb"), "b");
    // A macro that may not be there drops no argument.
    EXPECT_EQ(expanded("#ifdef GL_ES\n#define F(x)\n#endif\nF(float a[9];)"), "F ( float a [ 9 ] ; )");
    EXPECT_EQ(expanded("#define N 1\n#ifdef GL_ES\n#undef N\n#define N 2\n#endif\nN"), "N 1 2");
}

TEST(ShaderMacros, BombsAreRefusedByTheirCount) {
    const std::string reason = "more than 200000 tokens";
    expect_refused(doubling(60, "x") + "void f() {\n    A60;\n}\n", reason, "line 63");
    expect_refused("#define A(x) x x x x x x x x x x\n#define B(x) A(A(A(A(A(A(A(x)))))))\nvoid g(){B(q+=1.0;)}\n",
                   reason, "line 3");
    expect_refused(doubling(60, "") + "A60\n", reason, "line 62");
    expect_refused("#define F(x) x x\n#define G(x) F(F(F(F(x))))\n#define H(x) G(G(G(G(G(x)))))\nH(a)\n", reason,
                   "line 4");
    expect_refused(doubling(30, "1") + "#if A30\n#endif\n", reason, "line 32");
    expect_refused("#ifdef GL_ES\n" + doubling(30, "x") + "#endif\nA30\n", reason, "line 34");
    expect_refused(
        "#define CAT(a) a ## a\n#define C4(a) CAT(CAT(CAT(CAT(a))))\n" + doubling(18, "CAT(abcdefgh)") + "A18", reason,
        "line 22");
    expect_taken(doubling(10, "x") + "A10\n");
}

TEST(ShaderMacros, PlainTextIsCountedToo) {
    expect_refused(std::string(300000, ';'), "more than 200000 tokens", "line 1");
    expect_taken(std::string(100000, ';'));
}

TEST(ShaderMacros, DeepCallsAreRefusedNotFollowed) {
    const auto calls = [](int depth) {
        std::string text = "#define F(x) x\n";
        for (int i = 0; i < depth; ++i) text += "F(";
        return text + "x" + std::string(std::size_t(depth), ')');
    };
    expect_refused(calls(300), "calls of macros are nested more than 200 deep", "line 2");
    expect_refused(calls(50000), "more than 200000 tokens", "line 2");
    expect_taken(calls(50));
    expect_refused("void f() { x = " + std::string(5000, '(') + "1" + std::string(5000, ')') + "; }\n",
                   "brackets are nested more than 128 deep", "line 1");
}

TEST(ShaderTokens, WhatDriversMayReadOtherwiseIsRefused) {
    expect_refused("// a comment \\\nfloat x;\n", "ends with a backslash", "line 1");
    expect_refused("a\n/\\\n/ b\n", "a backslash follows a slash", "line 2");
    expect_refused("#def\\\nine A B\n", "divides a word", "line 1");
    expect_refused("// a comment \r float x;\n", "carriage return", "line 1");
    expect_refused("x\r float x;\n", "carriage return", "line 1");
    expect_taken("// lines end\r\nfloat x() { return 1.0; }\r\n");
}

TEST(ShaderArrays, AreCountedHoweverTheyAreWritten) {
    const std::string reason = "hold more than 65536 numbers";
    for (const char* const text : {"float a[200000000];",
                                   "float a[1 << 28];",
                                   "const int N = 1 << 28; float a[N];",
                                   "const int N = 300, M = N * 300; float a[M];",
                                   "#define N 1000000\nfloat a[N];",
                                   "float a[300][300];",
                                   "float[300] a[300];",
                                   "float[300][300] a;",
                                   "vec4 a[20000];",
                                   "mat4 a[5000];",
                                   "dmat2x3 a[6000];",
                                   "struct S { float a[300]; }; S s[300];",
                                   "struct S { float a[300]; } s[300];",
                                   "struct S { float a[300]; }; struct T { S s[10]; int n; }; T t[100];",
                                   "struct S { float a[60000]; }; S a, b;",
                                   "struct S { float a[60000]; }; S a; S b;",
                                   "float a[60000]; float b[60000];",
                                   "float a[60000], b[60000];",
                                   "float a = f(1, 2), b[100000];",
                                   "void f(in float a[100000]) {}",
                                   "void f(float x, const in float a[100000]) {}",
                                   "float[100000] f();",
                                   "struct S { float a[30000]; }; void f() { S s[] = S[](a, b, c); }",
                                   "struct S { float a[30000]; }; void f() { g(S[3](a, b, c)); }",
                                   "float a[40000] = b; float c[] = a;",
                                   "Engine a[1000];",
                                   "RL_IN(float) a[100000];",
                                   "for (int i = 0, a[100000];;) {}",
                                   "highp float a[100000];",
                                   "RL_VARYING float a[100000];",
                                   "RL_CONSTANT float[100000] a;",
                                   "void f() { float a[0x20000]; }",
                                   "float a[int(100000)];",
                                   "float a[0377777u];",
                                   "float a[(200 + 100) * 301 - 1];"})
        expect_refused(text, reason, std::string(text).find('\n') == std::string::npos ? "line 1" : "line 2");
}

TEST(ShaderArrays, OfSeveralConstantsOfOneNameTheLargestCounts) {
    expect_refused("const int N = 2; void f() { const int N = 1 << 28; float a[N]; }", "hold more than 65536 numbers",
                   "line 1");
    expect_taken("void f() { const int N = 3; float a[N]; } void g() { const int N = 5; float a[N]; }");
}

/// The process that compiles them first has limits.
TEST(ShaderArrays, ASizeThatCannotBeToldIsLeftToTheCompiler) {
    for (const char* const text :
         {"float a[n];", "float a[int(1e9)];", "float a[1 > 0 ? 100000 : 1];", "float a[65536 * 65536 / 4294967295u];",
          "float a[b.length()];", "float a[-1];", "float a[0];", "float a[1 / 0];", "float a[1 << 40];",
          "int N = 3; float a[N];", "float a[max(3, 4)];",
          "#define QUALITY 2\n#if QUALITY >= 2\n#define N 16\n#else\n#define N 4\n#endif\nfloat a[N];",
          "#if defined(A) && !defined(B)\n#define N 8\n#else\n#define N 4\n#endif\nfloat a[N];",
          "#if !defined(N)\n#define N 8\n#endif\nfloat a[N];",
          "#ifdef GL_ES\n#define N 4\n#else\n#define N 100000000\n#endif\nfloat a[N];"})
        expect_taken(text);
}

TEST(ShaderArrays, UsualTextsAreTaken) {
    for (const char* const text :
         {"float a[64]; vec3 b[256];", "const int N = 8; vec2 taps[N * N];", "void f() { a[i] = b[int(x)] + c[n][m]; }",
          "void f() { if (x > 0.0) a[i] = 1.0; else b[i] = 2.0; return; }",
          "struct S { vec3 p; float w[4]; }; S s[16];", "const float w[3] = float[3](1.0, 2.0, 3.0);",
          "const float w[] = float[](1.0, 2.0);",
          "LightTerms user_terms(MaterialSurface s, LightSample l) { LightTerms terms; return terms; }",
          "void f() { for (int i = 0, n = 4; i < n; ++i) sum += weight[i] * x[i].y; }",
          "#ifndef N\n#define N 16\n#endif\nfloat a[N];", "out vec3 to_light[8];", "precision highp float;",
          "float f(float x) { return x > 1.0 ? table[int(x)] : 0.5; }"})
        expect_taken(text);
    std::string many;
    for (int i = 0; i < 1000; ++i) many += "void f" + std::to_string(i) + "(LightTerms a) { vec4 x = vec4(0.0); }\n";
    expect_taken(many);
}

TEST(ShaderMacros, WhatIsSearchedOneByOneIsBounded) {
    std::string parameters = "a", definitions = "#ifdef RL_Q\n";
    for (int i = 0; i < 64; ++i) parameters += ",a" + std::to_string(i);
    for (int i = 0; i < 65; ++i) definitions += "#define A " + std::to_string(i) + "\n";
    expect_refused("#define A(" + parameters + ") a\n", "more than 64 parameters", "line 1");
    expect_refused(definitions + "#endif\n", "'A' has more than 64 meanings", "line 66");
}

TEST(ShaderArrays, NoTextMakesThemSlow) {
    // Each is as long as a text may be: were one part of it read again for each other, these would not end.
    std::string values, open, lists;
    for (int i = 0; i < 60000; ++i) values += "int a=";
    for (int i = 0; i < 60000; ++i) open += "a[1 ";
    for (int i = 0; i < 60000; ++i) lists += "a,";
    expect_taken(values);
    expect_refused(open, "brackets are nested", "line 1");
    expect_taken("int b=c(" + lists + "a);");
}

TEST(ShaderConstants, AreWholeNumbersOf32Bits) {
    const ShaderConstants known{{"N", 5}, {"odd", std::nullopt}};
    const auto value = [&](const std::string& text) {
        const ShaderTokens tokens = shader_tokens("a.glsl", text);
        return constant_value(tokens.all, known);
    };
    EXPECT_EQ(value("1 + 2 * 3 << 1"), 14);
    EXPECT_EQ(value("(1 + 2) * N - -4"), 19);
    EXPECT_EQ(value("10 - 4 - 3"), 3);
    EXPECT_EQ(value("7 & 5 | 8 ^ 1"), 13);
    EXPECT_EQ(value("0x10 + 010u"), 24);
    EXPECT_EQ(value("int(N) % 3"), 2);
    for (const char* const text : {"", "odd", "M", "1.5", "2147483647 + 1", "1 / 0", "1 2", "(1", "1 +", "1 < 2", "~1"})
        EXPECT_EQ(value(text), std::nullopt) << text;
}

}  // namespace
}  // namespace rakelight
