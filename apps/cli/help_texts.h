// SPDX-License-Identifier: Apache-2.0
// What stands below the options in --help.
#pragma once

namespace rakelight::cli {

inline constexpr const char* models_help =
    "Model files, world files (*.scene.toml), folders of such, builtin:teapot, builtin:sphere:tolerance=0.01, ..., or "
    "- for standard input";

inline constexpr const char* main_footer =
    R"(Without a verb, models are rendered where -o names a picture, and else opened in a window.

Examples:
  rakelight helmet.glb -o helmet.png                       # a picture
  rakelight models/ -o pictures/                           # one of each model in a folder
  rakelight body.glb wheels.glb --as-one -o car.png        # two files as one scene
  rakelight scan.ply --up +Z -o scan.png                   # a scan whose Z axis points up
  rakelight helmet.glb -o - | magick - helmet.gif          # a PNG to a pipe (-o ppm:- for PPM)
  rakelight shoe.glb --background white -o shoe.png        # a product on white
  rakelight cloud.ply -o cloud.png                         # a point cloud in its colors
  rakelight smooth knight.glb -o fixed.glb                 # no seams; skins and clips are kept
  rakelight inspect knight.glb --check --max-seam 2        # a gate for CI: exit code 5
  rakelight compare before.png helmet.glb --max-flip 0.05  # a model against a reference picture
  rakelight explain helmet.glb --pixel 640,360             # why that pixel is so dark

Colors are r,g,b from 0 to 1, '#rrggbb' or a name such as white. Switches stand alone or
take on, off, true, false, 1 or 0. Upper and lower case are the same in words.

Exit codes: 0 done, 1 failed, 2 wrong usage, 3 input not found, 4 file broken,
format not supported or nothing to draw, 5 a check found problems.
Environment: RAKELIGHT_ISA=scalar|sse2|avx2|avx512 forces an instruction set
(the picture stays the same), NO_COLOR switches colors of messages off.)";

inline constexpr const char* render_footer = R"(Lights:
  Without --light the model's own lights are used. Where it has none, metallic-
  roughness materials stand in a studio with a key light, others get a key light,
  a fill light and ambient light. Colors are linear, 1 is white.
    point:X,Y,Z         a lamp at a place; then any of
      :color=R,G,B      its color (default 1,1,1)
      :specular=R,G,B   the color of its highlights (default: as color)
      :ambient=R,G,B    what it adds on every side (default 0,0,0)
      :attenuation=C,L,Q  1 / (C + L d + Q d^2) at d meters (default 1,0,0)
    spot:X,Y,Z          like point, and
      :direction=X,Y,Z  the way its light goes (default 0,0,-1)
      :cutoff=DEG       half angle of its cone, up to 90
      :exponent=E       falls off as cos^E from the axis (default 0)
    directional:X,Y,Z   the way the light goes; :color= :specular= :ambient=
    ambient:R,G,B       light from everywhere
    photometric-point:X,Y,Z, photometric-spot:X,Y,Z, photometric-directional:X,Y,Z
                        as glTF has them: inverse square of the distance
      :intensity=I      candela, of directional ones lux (default 1); :color=
      :direction=X,Y,Z :inner=DEG :outer=DEG   spot: half angles of its cone
    of all but ambient: :shadow=off throws none; placed: :range=M ends at M meters
    default, studio     those lights although the model has its own
    none                no light
  Colors of lights may be written as '#rrggbb' or by name, too.

Examples:
  rakelight render helmet.glb -o helmet.png
      The first picture: fitted camera, light for its materials, 1280 x 720.
  rakelight render models/ --recursive -o 'pictures/{dir}/{model}-{ext}.jpg'
      Each model below a folder; pictures/ has the same subfolders then.
  rakelight render body.glb wheels.glb --as-one -o car.png
      Two files as one scene.
  rakelight render scan.stl --up +Z --view isometric -o scan.png
      A scan whose Z axis points up.
  rakelight render - --format glb -o - < helmet.glb
      From standard input to standard output: PNG; -o ppm:- writes PPM.
  rakelight render shoe.glb -o shoe.png --background white --resolution 2000,2000
      A product on white; --background transparent has alpha.
  rakelight render helmet.glb -o helmet.png --config look.toml
      Settings from a file: [render], then lines such as samples = 8.
  rakelight render knight.gltf -o walk.mp4 --animation-index 0
      A clip as a movie; inspect lists the clips. -o 'walk/{frame:4}.png' draws its
      numbered pictures; --frames 0:23 some of them (on several machines), and
      --skip-existing goes on. A sequence fits its view to the whole clip.
  rakelight render parts.obj -o parts.png --normals model --crease-angle 60
      Objects that touch look like one surface; edges over 60 degrees stay sharp.
  rakelight render head.obj -o head.png --camera-position 0,1,5 \
      --light point:2,3,4:attenuation=1,0,0.02 --light ambient:0.05,0.05,0.05
      Own camera and lights.
  rakelight render a.glb b.obj c.fbx -o 'out/{model}.png' --resolution 640,480
      Each model to its own picture; one that fails does not stop the others.
  rakelight render builtin:teapot -o teapot.apng --turntable 12 --fps 12
      Once around as a movie; with a clip named, it plays meanwhile
      (docs/sequences.md).
  rakelight render chair.glb -o chair.png --background transparent \
      --channels depth,normal
      With alpha; depth and normals go to chair.depth.exr and chair.normal.exr.
  rakelight render chair.glb -o chair.png --ref good/chair.png --ref-threshold 0.005
      Exit code 5, and a line, where it differs from the reference picture.
  rakelight render chair.glb -o chair.exr --channels all --channel-files layers
      One EXR: R, G, B and the layers depth.Z, normal.X, normal.Y, ...

Channels, of the nearest opaque surface; lengths in meters, directions in world
space:
  depth                 along the view axis; +inf where nothing is
  normal, face-normal   as it is lit, and of the triangle's plane; unit
  tangent               and the sign of the bitangent
  ambient-occlusion     share of ambient light that arrives, with that option
  uv, uv1               texture coordinates, v down
  position              in world space
  object, mesh, material, triangle   numbers from 0; -1 where nothing is (UINT
                        layers: 4294967295)
  barycentric           weights of the triangle's corners
  overdraw              opaque surfaces over the pixel, hidden ones too
  base-color            before lighting
  lighting              ambient, diffuse, specular, emission: their sum is the color
All else is 0 where nothing is.
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found,
4 file broken or nothing to draw, 5 past --ref-threshold; of several inputs the
largest. A signal ends
the program as that signal (130 and 143 in a shell) within half a second: no
unfinished file stays; --json prints nothing where work had to be broken off.)";

inline constexpr const char* inspect_footer =
    R"(Borders are world positions that two objects share. Their angle says how far
apart the nearest two normals there are; a seam is such an angle where smoothing
over the whole model would leave none. Edges sharper than --crease-angle are none.

Heat map: the model in gray, its seams from 0.01 degrees (dark blue) over 1
(violet), 5 (red) and 20 (orange) to 60 and more (light yellow).

Examples:
  rakelight inspect helmet.glb
  rakelight inspect parts.obj --normals object --heatmap seams.png
      How large the seams are when every object is smoothed by itself, and where.
  rakelight inspect parts.glb --check --max-seam 2 --no-t-junctions
      A gate for CI: exit code 5, and a line for each limit that is passed.
  rakelight inspect *.glb --report page.html --report checks.xml
      A page for people, and JUnit's XML with a test case for each check and model.
  rakelight inspect *.glb --json
      One row a file, schema rakelight.inspect/1.
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found,
4 file broken or too large, 5 a limit of --check is passed; of several inputs the
largest.)";

inline constexpr const char* smooth_footer =
    R"(Normals that the file has stay, but where parts meet: there they are joined over
edges that bend no more than the crease angle. Hard edges inside of a part stay,
and so do those between flat faces of two parts. What is not about normals and
tangents stays as it is: names, extras, animations, images, compression where no
normal changes. A second run changes nothing.

Examples:
  rakelight smooth parts.glb -o smooth.glb
  rakelight smooth models/ -o fixed/
      Each model of a folder, under its name.
  rakelight smooth parts.glb --preview look.html
      Heat maps of the seams before and after; no model is written.
  rakelight smooth parts.glb -o smooth.glb --normals model
      All normals made anew, over all objects.
  rakelight smooth parts.obj -o parts.obj --crease-angle 45
      In place; the old file is replaced when the new one is whole.
  rakelight smooth *.glb -o 'out/{model}.glb' --json
      One row a file, schema rakelight.smooth/1.
  rakelight smooth scan.stl -o scan.ply --crease-angle 180)";

inline constexpr const char* explain_footer =
    R"(The options are those of render: the pixel is that of the picture which render would
draw with them, and its numbers are the engine's own, to the bit.

Examples:
  rakelight explain helmet.glb --pixel 640,360
      Why that pixel is dark, or bright: each light, each factor.
  rakelight explain helmet.glb --pixel 640,360 --pixel 100,80 -o pixels.txt
      Each pixel says which object it shows, or where the nearest one is.
  rakelight explain builtin:teapot --resolution 320,240 --pixel 100,120 --json
      Schema rakelight.explain/1.)";

inline constexpr const char* bench_footer =
    R"(Examples:
  rakelight bench smooth --triangles 100k --with all
      Normals and tangents beside the plain loop that everybody writes.
  rakelight bench render helmet.glb --samples 4 --json
      Schema rakelight.bench/1.
  rakelight bench render --lights 8,1000 --roughness 0.4
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found, 4 file
broken or too large.)";

inline constexpr const char* thumbnail_footer =
    R"(A model that takes more is given up with exit code 1, so that no file, however it is made,
keeps a file manager waiting. Textures are read from the model's own folder, where
the file manager lets the program see it.

Examples:
  rakelight thumbnail helmet.glb helmet.png 256
  rakelight thumbnail file:///home/me/a%20helmet.glb /tmp/thumbnail.png 128)";

inline constexpr const char* check_footer =
    R"(Examples:
  rakelight check world.scene.toml
      Exit code 0 when it loads, else one line with line and column.
  rakelight check *.glb --json
      One row a file, schema rakelight.check/1.
  rakelight check --schema)";

inline constexpr const char* compare_footer =
    R"(Max error, RMSE, PSNR and differing pixels are of the numbers in the files: codes as
0 to 1, EXR and HDR as linear light, alpha too. SSIM and FLIP look at 8-bit sRGB
colors as a display shows them: linear light is clamped to 0..1 and encoded, where
alpha is below 1 the color lies over middle gray.
Limits and --tolerance are numbers or fractions: --max-error 2/255.

Examples:
  rakelight compare before.png after.png
  rakelight compare before.png after.png -o difference.png --max-flip 0.05
      Exit code 5, and a line for each limit that is passed.
  rakelight compare before/ after/ -o page.html
      Two folders: the pictures of equal names, on one page with wipe sliders.
  rakelight compare before.png helmet.glb --max-flip 0.05
      A model as it is drawn now against a reference picture, in that one's size.
  rakelight compare parts.glb smooth.glb -o page.html --view isometric
      Scenes are rendered, both with the same settings.
  rakelight compare --engines soft,soft builtin:teapot --json
      Schema rakelight.compare/1.
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found,
4 file broken or too large, 5 a limit is passed, the pictures differ in size, or a
file is in one folder only; of several pairs the largest.)";

inline constexpr const char* join_windows_footer =
    R"(The pixels are those of one whole run, and the bytes of a PNG too. Parts may overlap where
they are equal. They are read row by row: a picture need not fit into memory.

Examples:
  rakelight render helmet.glb --resolution 2000,1000 --window 0,0,1000,1000 -o left.png
  rakelight render helmet.glb --resolution 2000,1000 --window 1000,0,1000,1000 -o right.png
  rakelight join-windows left.png right.png -o helmet.png
      Many windows on a cluster: docs/cluster.md.
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 a part not found, 4 a part
broken, missing, of another picture, or different from one that it overlaps.)";

inline constexpr const char* bake_footer =
    R"(Rays go along LOW's smooth normals from a cage around it inward; the first triangle of
HIGH that faces outward is what a texel shows. Both models may have many objects; those of
LOW share one map. Texture coordinates are those of set 0; where LOW has none, charts are
made of it: write --model then.

Maps: normal is 0.5 + 0.5 n; height 0.5 at LOW, 0 and 1 at the cage; curvature 0.5 where
flat, 1 where convex; occlusion 1 where the sky is open; light is that of HIGH's lights and
of what its surfaces send on (radiosity), in sRGB, 1 at most. EXR files have height in meters,
curvature in 1/meters, light linear without an end.

Examples:
  rakelight bake scan.obj simple.obj -o 'maps/{map}.png' --maps normal,height
  rakelight bake scan.obj simple.obj -o normal.png --size 2048 --model baked.glb
      And the model with the map, to look at: rakelight baked.glb
  rakelight bake scan.obj simple.obj -o normal.png --distance 0.02 --green down
Exit codes: 0 done, 1 failed or cancelled, 2 wrong usage, 3 input not found, 4 file broken,
too large or no ray of LOW meets HIGH.)";

inline constexpr const char* radiosity_footer =
    R"(Diffuse surfaces light one another: lamps, surfaces that shine and the environment send
out light, what each surface reflects goes on to the others. The result is drawn as it is, from
anywhere, by any viewer of glTF. Metal, glass and highlights are left out.

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
