# Writes a source with the texts of files as they stand: cmake -DOUT=... -DROOT=src -DFILES="a.glsl;b.glsl" -P EmbedText.cmake
set(rows "")
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} text)
  string(APPEND rows "    {\"${file}\", R\"rakelight(${text})rakelight\"},\n")
endforeach()
file(WRITE ${OUT}.new "// Made by cmake/EmbedText.cmake.\n#include \"engines/opengl/programs/embedded_texts.h\"\n\nnamespace rakelight::opengl {\nstatic const EmbeddedText texts[] = {\n${rows}};\nconst std::span<const EmbeddedText> embedded_texts(texts);\n}  // namespace rakelight::opengl\n")
file(RENAME ${OUT}.new ${OUT})
