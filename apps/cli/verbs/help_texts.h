// SPDX-License-Identifier: Apache-2.0
// The texts below the options in --help.
#pragma once

namespace rakelight::cli {

inline constexpr const char* models_help =
    "Model files, world files (*.scene.toml), folders of them, as paths or addresses (file:///home/me/a%20model.glb), "
    "builtin:teapot, builtin:sphere:tolerance=0.01, ..., or - for standard input";

inline constexpr const char* main_footer =
#if RL_PROCESSES
    R"(Without a subcommand, models are rendered if -o names a picture, converted if it names a model,
and opened in a window if there is no -o.)"
#else
    "Without a subcommand, models are rendered if -o names a picture, and converted if it names a model."
#endif
    R"(

Examples:
  rakelight helmet.glb -o helmet.png                       # a picture
  rakelight models/ -o pictures/                           # one picture per model in a folder
  rakelight body.glb wheels.glb --as-one -o car.png        # two files as one scene
  rakelight scan.ply --up +Z -o scan.png                   # a scan whose Z axis points up
  rakelight helmet.glb -o - | magick - helmet.gif          # a PNG to a pipe (-o ppm:- for PPM)
  rakelight shoe.glb --background white -o shoe.png        # a product on white
  rakelight cloud.ply -o cloud.png                         # a point cloud in its colors
  rakelight smooth knight.glb -o fixed.glb                 # no seams; skins and clips are kept
  rakelight robot.fbx -o robot.glb                         # another format, normals untouched
  rakelight inspect knight.glb --check --max-seam 2        # a gate for CI: exit code 5
  rakelight compare before.png helmet.glb --max-flip 0.05  # a model against a reference picture
  rakelight explain helmet.glb --pixel 640,360             # why that pixel is so dark

Colors are r,g,b from 0 to 1, '#rrggbb' or a name such as white. Switches stand alone or
take on, off, true, false, 1 or 0. Words may be in upper or lower case.

Exit codes: 0 done, 1 failed, 2 wrong usage, 3 input not found, 4 file broken,
format not supported or nothing to draw, 5 a check found problems.
Environment: RAKELIGHT_ISA=scalar|sse2|avx2|avx512 forces an instruction set
(the picture stays the same), NO_COLOR disables colored messages.)";

inline constexpr const char* render_footer = R"(Lights:
  Without --light the model's own lights are used. If it has none, metallic-roughness
  materials are lit by a studio environment and a key light, others by a key light, a
  fill light and ambient light. Colors are linear, 1 is white.
    point:X,Y,Z         a lamp at a position, followed by any of
      :color=R,G,B      its color (default 1,1,1)
      :specular=R,G,B   the color of its highlights (default: as color)
      :ambient=R,G,B    its ambient term (default 0,0,0)
      :attenuation=C,L,Q  1 / (C + L d + Q d^2) at d meters (default 1,0,0)
    spot:X,Y,Z          like point, and
      :direction=X,Y,Z  direction of its light (default 0,0,-1)
      :cutoff=DEG       half angle of its cone, up to 90
      :exponent=E       falls off as cos^E from the axis (default 0)
    directional:X,Y,Z   direction of the light; :color= :specular= :ambient=
    ambient:R,G,B       ambient light
    photometric-point:X,Y,Z, photometric-spot:X,Y,Z, photometric-directional:X,Y,Z
                        as in glTF: inverse square of the distance
      :intensity=I      candela, for directional lights lux (default 1); :color=
      :direction=X,Y,Z :inner=DEG :outer=DEG   spot: half angles of its cone
    all but ambient: :shadow=off casts no shadow; point and spot: :range=M ends at M meters
    default, studio     these lights in place of the model's own
    none                no light
  Colors of lights may also be '#rrggbb' or a name.

Examples:
  rakelight render helmet.glb -o helmet.png
      A fitted camera, lights that suit the materials, 1280 x 720.
  rakelight render models/ --recursive -o 'pictures/{dir}/{model}-{ext}.jpg'
      Each model below a folder; pictures/ gets the same subfolders.
  rakelight render body.glb wheels.glb --as-one -o car.png
      Two files as one scene.
  rakelight render scan.ply --up +Z --view isometric -o scan.png
      A scan whose Z axis points up.
  rakelight render - --format glb -o - < helmet.glb
      From standard input to standard output: PNG; -o ppm:- writes PPM.
  rakelight render shoe.glb -o shoe.png --background white --resolution 2000,2000
      A product on white; --background transparent writes alpha.
  rakelight render helmet.glb -o helmet.png --config look.toml
      Settings from a file: [render], then lines such as samples = 8.
  rakelight render knight.gltf -o walk.mp4 --animation-index 0
      A clip as a movie; inspect lists the clips. -o 'walk/{frame:4}.png' writes numbered
      pictures, --frames 0:23 some of them (for several machines), and --skip-existing
      continues an interrupted run. The view is fitted to the whole clip.
  rakelight render parts.obj -o parts.png --normals model
      Objects that touch look like one surface; hard edges are found by its planes.
  rakelight render head.obj -o head.png --camera-position 0,1,5 \
      --light point:2,3,4:attenuation=1,0,0.02 --light ambient:0.05,0.05,0.05
      A camera and lights of your own.
  rakelight render a.glb b.obj c.fbx -o 'out/{model}.png' --resolution 640,480
      Each model to its own picture; one that fails does not stop the others.
  rakelight render builtin:teapot -o teapot.apng --turntable 12 --fps 12
      One turn as a movie; a named clip plays meanwhile (docs/sequences.md).
  rakelight render chair.glb -o chair.png --background transparent \
      --channels depth,normal
      With alpha; depth and normals go to chair.depth.exr and chair.normal.exr.
  rakelight render chair.glb -o chair.png --ref good/chair.png --ref-threshold 0.005
      Exit code 5 and a message if it differs from the reference picture.
  rakelight render chair.glb -o chair.exr --channels all --channel-files layers
      One EXR: R, G, B and the layers depth.Z, normal.X, normal.Y, ...

Channels, of the nearest opaque surface; lengths in meters, directions in world
space:
  depth                 along the view axis; +inf in the background
  normal, face-normal   shading normal, and normal of the triangle's plane; unit length
  tangent               tangent, and the sign of the bitangent
  ambient-occlusion     fraction of ambient light that arrives; needs that option
  uv, uv1               texture coordinates, v down
  position              in world space
  object, mesh, material, triangle   numbers from 0; -1 in the background (UINT
                        layers: 4294967295)
  barycentric           weights of the triangle's corners
  overdraw              number of opaque surfaces that cover the pixel, hidden ones too
  base-color            before lighting
  lighting              ambient, diffuse, specular, emission: their sum is the color
All other channels are 0 in the background.
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found,
4 file broken or nothing to draw, 5 beyond --ref-threshold; with several inputs the
largest. A signal ends the program as that signal (130 or 143 in a shell) within half a
second, unless all the work is done already: then the exit code is that of the work. No
unfinished file remains. With --json, what was interrupted has the error "cancelled".)";

inline constexpr const char* inspect_footer =
    R"(A border is a world position that two meshes share: objects, or parts of one object with
materials of their own. Its angle is that between the nearest two normals there. A seam
is such an angle that rakelight smooth would remove. Hard edges (--crease) are no seams,
nor are creases that were authored hard.

Heat map: the model in gray, its seams from 0.01 degrees (dark blue) through 1
(violet), 5 (red) and 20 (orange) to 60 and more (light yellow).

Examples:
  rakelight inspect helmet.glb
  rakelight inspect parts.obj --normals object --heatmap seams.png
      Size and place of the seams when every object is smoothed by itself.
  rakelight inspect parts.glb --check --max-seam 2 --no-t-junctions
      A gate for CI: exit code 5, and a line for each limit that is exceeded.
  rakelight inspect *.glb --report page.html --report checks.xml
      A page to read, and JUnit XML with a test case for each check and model.
  rakelight inspect *.glb --json
      One row a file, schema rakelight.inspect/1.
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found,
4 file broken or too large, 5 a limit of --check is exceeded; with several inputs the
largest.)";

inline constexpr const char* smooth_footer =
    R"(Normals of the file are kept, except where parts meet: there they are joined across
soft edges (--crease). Hard edges within a part are kept, and so are those between two
parts where both were authored hard. Files whose open borders fit together
are smoothed as one model, each into its own output. Everything but normals and tangents
is kept: names, extras, animations, images, and compression where no normal changes. One
line says how many normals turned, and by how much at most; --quiet leaves it out. A
second run changes nothing.

Examples:
  rakelight smooth parts.glb -o smooth.glb
  rakelight smooth models/ -o fixed/
      Each model of a folder, under its name.
  rakelight smooth head.glb body.glb -o fixed/
      The seam between two files too: fixed/head.glb and fixed/body.glb.
  rakelight smooth parts.glb --preview look.html
      Heat maps of the seams before and after; no model is written.
  rakelight smooth parts.glb -o smooth.glb --normals model
      All normals recomputed, smooth across all objects.
  rakelight smooth parts.obj -o parts.obj --crease-angle 45
      In place; the old file is replaced when the new one is complete.
  rakelight smooth *.glb -o 'out/{model}.glb' --json
      One row a file, schema rakelight.smooth/1.
  rakelight smooth scan.stl -o scan.ply --crease-angle 180)";

inline constexpr const char* convert_footer =
    R"(No normal is computed: what the file has is written, and meshes without normals stay
without. From .gltf to .glb and back everything is kept. Other conversions keep materials,
textures, skins and clips as far as the format can express them; the rest is listed.
OBJ and PLY store positions in world space, and skinned models in bind pose.

Examples:
  rakelight convert robot.fbx -o robot.glb
  rakelight robot.fbx -o robot.glb
      The same: the ending of -o says that a model is to be written.
  rakelight convert models/ -o 'out/{model}.gltf'
      Each model of a folder.
  rakelight convert body.obj wheels.obj --as-one -o car.glb
      Two files in one.
  rakelight convert helmet.glb -o helmet.obj
      With helmet.mtl, and textures as files.
  rakelight convert *.fbx -o 'out/{model}.glb' --json
      One row a file, schema rakelight.convert/1.
Seam-free normals: rakelight smooth.)";

inline constexpr const char* explain_footer =
    R"(The options are those of render. The pixel is that of the picture that render would draw
with them, and its numbers are the engine's own, to the bit.

Examples:
  rakelight explain helmet.glb --pixel 640,360
      Why that pixel is dark, or bright: each light, each factor.
  rakelight explain helmet.glb --pixel 640,360 --pixel 100,80 -o pixels.txt
      For each pixel: which object it shows, or where the nearest one is.
  rakelight explain builtin:teapot --resolution 320,240 --pixel 100,120 --json
      Schema rakelight.explain/1.)";

inline constexpr const char* bench_footer =
    R"(Examples:
  rakelight bench smooth --triangles 100k --with all
      Normals and tangents, next to a plain loop.
  rakelight bench render helmet.glb --samples 4 --json
      Schema rakelight.bench/1.
  rakelight bench render --lights 8,1000 --roughness 0.4
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found, 4 file
broken or too large.)";

inline constexpr const char* thumbnail_footer =
    R"(If a model needs more, the program ends with exit code 1 or 4. So no file can keep a file
manager waiting. Textures are decoded at a reduced size. The less important ones are left
out if decoding would take more than about half of that time. Textures are read from the
folder of the model, if the file manager gives the program access to it.

Examples:
  rakelight thumbnail helmet.glb helmet.png 256
  rakelight thumbnail file:///home/me/a%20helmet.glb thumbnail.png 128)";

inline constexpr const char* check_footer =
    R"(Examples:
  rakelight check world.scene.toml
      Exit code 0 if it loads, else a message with line and column.
  rakelight check *.glb --json
      One row a file, schema rakelight.check/1.
  rakelight check --schema)";

inline constexpr const char* compare_footer =
    R"(Max error, RMSE, PSNR and differing pixels compare the numbers in the files, alpha too:
codes as 0 to 1, EXR and HDR as linear light. SSIM and FLIP compare 8-bit sRGB colors
as displayed: linear light is clamped to 0..1 and encoded; where alpha is below 1, the
color lies over middle gray.
Limits and --tolerance are numbers or fractions: --max-error 2/255.

Examples:
  rakelight compare before.png after.png
  rakelight compare before.png after.png -o difference.png --max-flip 0.05
      Exit code 5, and a line for each limit that is exceeded.
  rakelight compare before/ after/ -o page.html
      Two folders: the pictures of equal names, on one page with wipe sliders.
  rakelight compare before.png helmet.glb --max-flip 0.05
      A model as drawn now against a reference picture, at its size.
  rakelight compare parts.glb smooth.glb -o page.html --view isometric
      Scenes are rendered, both with the same settings.
  rakelight compare --engines soft,soft builtin:teapot --json
      Schema rakelight.compare/1.
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found,
4 file broken or too large, 5 a limit is exceeded, the pictures differ in size, or a
file is in one folder only; with several pairs the largest.)";

inline constexpr const char* join_windows_footer =
    R"(The pixels are those of one whole run, and so are the bytes of a PNG. Windows may overlap
where they are equal. They are read row by row, so a picture need not fit into memory.

Examples:
  rakelight render helmet.glb --resolution 2000,1000 --window 0,0,1000,1000 -o left.png
  rakelight render helmet.glb --resolution 2000,1000 --window 1000,0,1000,1000 -o right.png
  rakelight join-windows left.png right.png -o helmet.png
      Many windows on a cluster: docs/cluster.md.
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 a window not found, 4 a
window broken, missing, of another picture, or different from one that it overlaps.)";

inline constexpr const char* bake_footer =
    R"(Rays start at a cage around LOW and go inward along its smooth normals. A texel shows the
first triangle of HIGH that faces outward. Both models may have many objects; those of LOW
share one map. Texture coordinates are those of set 0; if LOW has none, they are generated:
add --model then.

Maps: normal is 0.5 + 0.5 n; height 0.5 at LOW, 0 and 1 at the cage; curvature 0.5 where
flat, 1 where convex; occlusion 1 where nothing occludes; light is that of HIGH's lights and
of diffuse interreflection (radiosity), in sRGB, clamped at 1. EXR files have height in
meters, curvature in 1/meters, and linear light without clamping.

Examples:
  rakelight bake scan.obj simple.obj -o 'maps/{map}.png' --maps normal,height
  rakelight bake scan.obj simple.obj -o normal.png --size 2048 --model baked.glb
      And the model with the map, to look at: rakelight baked.glb
  rakelight bake scan.obj simple.obj -o normal.png --distance 0.02 --green down
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found, 4 file broken,
too large, or no ray from LOW hits HIGH.)";

inline constexpr const char* radiosity_footer =
    R"(Diffuse surfaces light one another: lamps, emissive surfaces and the environment emit
light, and each surface reflects light to the others. Any glTF viewer shows the result, from
any viewpoint. Metal, glass and highlights are left out.

Examples:
  rakelight radiosity room.scene.toml -o room-lit.glb
  rakelight room-lit.glb -o room.png
  rakelight radiosity room.scene.toml -o room-lit.glb --radiosity-elements 100000
      Finer shadows, in more time: docs/radiosity.md.
  rakelight radiosity room.scene.toml -o room-lit.glb --lightmap 2048
      The light as a texture, on the room's own triangles.
  rakelight render room.scene.toml -o room.png --method radiosity
      A picture, by any engine.)";

inline constexpr const char* stages_footer =
    R"(Stages: model, world, camera and clip space, clipped polygons, normalized device
coordinates, screen, culled faces, coverage, depth, visibility, normals, each light's
ambient, diffuse and specular term, the picture. Open DIR/index.html in a browser.

Examples:
  rakelight stages helmet.glb -o helmet-stages
  rakelight stages helmet.glb -o helmet.html --single-file
  rakelight stages *.glb -o 'out/{model}' --resolution 640,360)";

}  // namespace rakelight::cli
