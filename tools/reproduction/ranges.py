# SPDX-License-Identifier: Apache-2.0
"""The allowed range of each number: from, to. A range holds for the pictures of docs/reproduction.md and for the small ones of the tests. So it is as wide as the claim
allows, not as narrow as one run. For a claim that did not hold, the range is that of the measured result (the page lists these)."""
INF = float("inf")
NONE, SOME = (0, 0), (1e-9, INF)
TINY = (0, 1e-5)

RANGES = {
    "s1-fig3": {
        **{f"{n} triangles, gouraud: difference to the finest [1/255]": r for n, r in ((224, (12, 20)), (960, (4.9, 8)), (3968, (2, 4)))},
        **{f"{n} triangles, phong: difference to the finest [1/255]": r for n, r in ((224, (8, 12)), (960, (3, 4.8)), (3968, (1, 2.5)))},
        "brightest pixel of 224 triangles, gouraud [1/255]": (100, 170), "brightest pixel of 224 triangles, phong [1/255]": (195, 255),
        "lighting evaluations, phong over gouraud, 224 triangles": (100, INF)},
    "s1-large-face": {
        **{f"{light}, gouraud: middle minus side [linear]": (-0.01, 0.01) for light in ("spot light", "highlight")},
        **{f"{light}, phong: middle minus side [linear]": (0.5, INF) for light in ("spot light", "highlight")}},
    "s1-mixed": {
        "evaluations, mixed over gouraud": (1.05, INF), "evaluations, mixed over phong": (0.01, 0.95),
        "part0: sampled pixels equal to all flat [%]": (100, 100), "part0: sampled pixels equal to all phong [%]": (0, 60),
        "part2: sampled pixels equal to all phong [%]": (100, 100), "part2: sampled pixels equal to all flat [%]": (0, 60),
        "other parts: sampled pixels equal to all gouraud [%]": (100, 100), "other parts: sampled pixels equal to all phong [%]": (20, 90),
        "two spheres, gouraud: difference to phong [1/255]": (2, 6), "two spheres, auto: difference to phong [1/255]": (0.1, 1),
        "two spheres, auto: evaluations over phong": (1.001, 1.1), "two spheres, gouraud: evaluations over phong": (0.05, 0.3)},
    "s1-fig4": {"pixels with a tilted normal, without the map [%]": NONE, "pixels with a tilted normal, with the map [%]": (40, 95)},
    "s1-fig5": {
        "mean blue of the map [1/255]": (200, 255), "distance from green down to dark over dark down to green": (1.8, INF), "difference with and without [1/255]": (10, 60)},
    "s1-fig6-8": {"sampled pixels": (20, 45), "largest angle of the tangent to U [degrees]": (0, 0.1), "bitangents that go up in the texture [%]": (100, 100)},
    "s1-fig10": {
        **{f"lamp at the {lamp}, normal {name}: light of the {side} face over that with the normal in the middle": (1.05, 1.8) if lamp == "left" else (0.3, 0.93)
           for lamp in ("left", "right") for name in ("half-way", "left") for side in ("left", "right")}},
    "s1-fig13": {
        "none: error of the right angle between normal and tangent [degrees]": (1.4, 5),
        "at the vertices: error of the right angle between normal and tangent [degrees]": (0.3, 1.3),
        **{f"{way}: error of the right angle between normal and tangent [degrees]": TINY for way in ("at the pixels", "at both")},
        "none vs. at the pixels [1/255]": (0.15, 0.5), "at the vertices vs. at the pixels [1/255]": (0.02, 0.14), "at both vs. at the pixels [1/255]": (0, 0.14),
        "pixels that differ by more than 10 codes, none vs. at the pixels [%]": (0, 0.1)},
    "s1-routine": {
        "sampled pixels": (121, 121), **{f"{what} of both: difference [degrees]": (0, 1e-4) for what in ("normals", "tangents")},
        "tangents of both with Gram-Schmidt: difference [degrees]": (0, 1e-4),
        "tangents with Gram-Schmidt vs. those without [degrees]": (1, 5)},
    "s1-fig7": {
        **{f"{how}: largest difference of normals, map of constant tilt [degrees]": (0, 0.01) for how in ("along u", "all turned by 50 degrees")},
        "each turned differently: largest difference of normals, map of constant tilt [degrees]": (30, 90)},
    "s1-tangents-smoothed": {
        "normals smoothed: largest rotation of the tangent from pixel to pixel [degrees]": (2, 20),
        "tangents smoothed, too: largest rotation of the tangent from pixel to pixel [degrees]": (0.1, 1.2),
        "normals alone vs. both [1/255]": (0.6, 4)},
    "s1-handedness": {
        "with the step: left half [1/255]": (0, 0.5), "with the step: mirrored half [1/255]": (12, 30), "without it, signs kept: left half [1/255]": (0, 0.5),
        "without it, signs kept: mirrored half [1/255]": (1, 9),
        **{f"{way}: axes of the mirrored half that point the wrong way": NONE for way in ("averaged tangents", "without it, signs kept")},
        **{f"{way}: axes of the mirrored half that point the wrong way": (1, 1) for way in ("with the step", "printed shader, step", "printed shader, no step")}},
    "s1-fig9-12": {
        "largest seam between objects, face [degrees]": (5, 180), "largest seam between objects, object [degrees]": (5, 180), "largest seam between objects, model [degrees]": NONE,
        "per face vs. whole model [1/255]": (2, 10), "per object vs. whole model [1/255]": (0.2, 1.5), "per object vs. whole model: pixels that differ [%]": (0.5, 5),
        "objects": (6, 6)},
    "s1-stored": {"largest difference of the pictures [1/255]": NONE, "without stored normals vs. with them [1/255]": (1, 6)},
    "s2-stages": {
        "stages of the lecture that have a table": (18, 18), "camera space: error to the lecture's formula [m]": TINY,
        "clip space: error to the projection of camera space [1]": TINY,
        "device space: error to x / w, y / w [1]": TINY, "screen: error to width (x + 1) / 2, height (1 - y) / 2 [px]": (0, 1e-4)},
    "s2-projection": {
        **{f"corner of the view after step 1, {axis} / -z": (0.999999, 1.000001) for axis in "xy"}, "depth of the near plane": (-1e-6, 1e-6),
        "depth of the far plane": (0.999999, 1.000001), **{f"three steps vs. the engine, {what} [1]": TINY for what in ("x, y, w", "depth")},
        "all three multiplied as printed: depth of the far plane minus that of the near one": (-1e-9, 1e-9)},
    "s2-parallel": {
        "parallel projection: pixels of a sphere at 6 m over those at 4 m": (0.98, 1.02), "central projection: pixels of a sphere at 6 m over those at 4 m": (0.38, 0.48),
        "parallel projection: x and y of the box over those of the camera, largest over smallest": (1, 1.0001),
        "central projection: x and y of the box over those of the camera, largest over smallest": (1.1, 3)},
    "s2-wrap-round": {"triangles through the plane of the eye": SOME, "pixels that clipping first changes [%]": (20, 100), "smallest w after clipping [m]": SOME},
    "s2-clipping": {
        "polygons cut at the four sides": SOME, "polygons completely outside": SOME, "objects dropped, teapot in view": NONE, "objects dropped, close view of a table": SOME,
        "close view vs. the middle of a wide one: pixels that differ [%]": (0, 0.05)},
    "s2-culling": {
        "faces of a closed sphere that culling drops [%]": (50, 75), "pixels of it that change [%]": NONE, "pixels of an open box that change [%]": (8, 25),
        "box treated as clockwise: cull back vs. cull front [% of pixels]": NONE},
    "s2-painter": {
        "cyclic overlap: pixels that the painter has wrong [%]": (0.2, 5), "crossing triangles: pixels that the painter has wrong [%]": (1, 10),
        "teapot: pixels that the painter has wrong [%]": (0.01, 1), "cyclic overlap in the opposite order: pixels that change, painter [%]": (0.5, 5),
        "cyclic overlap in the opposite order: pixels that change, z-buffer [%]": NONE},
    "s2-z-buffer": {
        **{f"{scene}: pixels that differ, the worst of four formats [%]": (0, 0.05) for scene in ("cyclic", "crossing", "teapot")},
        "planes 2 cm apart at 20 m: pixels that z16 has wrong [%]": (5, 40), "planes 2 cm apart at 20 m: pixels that z24 has wrong [%]": NONE,
        "the same with near 0.15 m, far 40 m: pixels that z16 has wrong [%]": (1, 40), "the same with near 5 m, far 40 m: pixels that z16 has wrong [%]": (0, 0.1)},
    "s2-depth-precision": {
        "near [m]": (1, 1), "far [m]": (1000, 1000), "depths in the first 2 % of the range [%]": (95.32, 95.34), "the same by the formula [%]": (95.32, 95.34),
        "range that 98 % of the depths reach [%]": (4.67, 4.68)},
    "s2-shading": {
        "unlit: evaluations at 320 x 240": NONE, "flat: evaluations at 320 x 240": (500, 1200), "gouraud: evaluations at 320 x 240": (500, 1200),
        "phong: evaluations at 320 x 240": (1300, INF), "unlit: evaluations, twice as wide and high over 320 x 240": (1, 1),
        **{f"{how}: evaluations, twice as wide and high over 320 x 240": (1, 1.2) for how in ("flat", "gouraud")},
        "phong: evaluations, twice as wide and high over 320 x 240": (3.8, 4.2),
        **{f"{how}, 4 divisions: inside, difference to faces as small as pixels [1/255]": r
           for how, r in (("unlit", (24, 32)), ("flat", (19, 23.9)), ("gouraud", (9, 18.9)), ("phong", (2, 8.9)))},
        "gouraud, 16 divisions: inside, difference to faces as small as pixels [1/255]": (3.2, 7),
        "phong, 16 divisions: inside, difference to faces as small as pixels [1/255]": (0.3, 3.1)},
    "s2-rays": {
        "tests of the naive loop over pixels x triangles": (1, 1), "pixels of the naive loop that differ from the tree's [%]": (0, 0.1),
        "sphere by its formula vs. its triangles: pixels that differ [%]": (5, 40), "the same, triangles with a hundredth of the error: pixels that differ [%]": (0, 2),
        "triangles by rays vs. incremental synthesis: pixels that differ [%]": (0, 0.5),
        "reflected rays": SOME, "refracted rays": SOME, "glass and mirrors vs. local light [1/255]": (25, 100),
        "raster: pixels that an algorithm for shadows changes [%]": (15, 60),
        "rays vs. the z-buffer, cyclic overlap: pixels that differ [%]": (0, 0.5)},
    "s3-fig1": {
        "triangles, detailed over coarse": (9, INF), "coarse vs. detailed [1/255]": (5, 40), "coarse with the map vs. detailed [1/255]": (0.5, 10),
        "error that the map leaves [%]": (5, 75)},
    "s3-fig2-3": {
        "sampled pixels": (15, 24), "normal: error to the interpolated one of the corners [degrees]": (0, 0.001), "number of normals, phong over flat": (4, INF),
        "flat vs. phong [1/255]": (5, 20)},
    "s3-fig4": {"texture and map vs. texture alone [1/255]": (2, 12), "pixels that the map changes [%]": (15, 60)},
    "s3-fig5-7": {
        **{f"{shape}: {color} at its {side}, over 128": (30, 127) if (shape == "bump") == (side in ("right side", "top")) else (-128, -30)
           for shape in ("bump", "dent") for color, sides in (("red", ("right side", "left side")), ("green", ("top", "bottom"))) for side in sides},
        "section: steep texels whose red points downhill [%]": (100, 100), "smallest blue of the map": (129, 255),
        "code 128 with zero at 127.5: tilt of the normal [degrees]": (0.1, 0.5), "code 128 with zero at 128: tilt of the normal [degrees]": NONE},
    "s3-blue": {
        "warnings": (1, 1), "normal of the part, component along that of the face": (-1, -0.5), "normal of the rest, component along that of the face": (0.99, 1),
        "light of the part over that of the rest": (0, 0.5)},
    "s3-fig8": {
        "leaning frames: pixel vs. world [1/255]": (0.5, 8), "orthonormal frames: pixel vs. world [1/255]": (0, 0.05),
        "leaning frames: transposed vs. inverse, both at the vertices [1/255]": (0.5, 8), "faces' own frames: transposed vs. inverse, both at the vertices [1/255]": (0, 0.05),
        "leaning frames: light at vertices vs. world, pixels that differ [%]": (10, 50)},
    "s3-fig9": {
        **{f"{method} vs. normal mapping [1/255]": (10, 50) for method in ("parallax-limited", "parallax", "steep")},
        "mean shift at 0 degrees [% of the texture]": (0.1, 0.6), "mean shift at 48 degrees [% of the texture]": (1, 1.7),
        "mean shift at 73 degrees [% of the texture]": (1.75, 3)},
    "s3-fig10": {
        **{f"{method} at {view} degrees: difference to displacement [1/255]": r for view, values in (
            (0, ((10, 20), (3, 9), (3, 9), (2, 8), (2, 8))), (48, ((31, 40), (25, 31), (24, 30), (8, 18), (8, 17))), (73, ((35, 45), (28, 34), (25, 34), (12, 24), (10, 22))))
           for method, r in zip(("normal", "parallax-limited", "parallax", "steep", "occlusion"), values)},
        "error at 73 degrees that parallax-limited removes [%]": (8, 20),
        **{f"grooves {depth} deep, {method}: pixels of the floor [%]": r for depth, values in (
            ("0.06", ((35, 60), (20, 34), (5, 16), (5, 16), (5, 16))), ("0.2", ((35, 60), (6, 34), (6, 34), (0, 0.5), (0, 0.5))))
           for method, r in zip(("none", "parallax-limited", "parallax", "steep", "displacement"), values)}},
    "s3-depth": {
        **{f"depth {depth}, {method}: difference to displacement [1/255]": r for depth, values in (("0.005", (1, 5)), ("0.05", (24, 34)), ("0.12", (30, 45)))
           for method, r in zip(("normal", "parallax"), (values, values))},
        **{f"depth {depth}: parallax vs. normal mapping [1/255]": r for depth, r in (("0.005", (0.5, 3)), ("0.05", (15, 28)), ("0.12", (28.5, 40)))},
        "steep: pixels that shadows of bumps change [%]": (4, 20), "normal: the same place from two sides, texture moves [% of the texture]": (0, 0.3),
        "parallax: the same place from two sides, texture moves [% of the texture]": (0.45, 4)},
    "s3-outline": {
        **{f"{method}: pixels of the outline that change [%]": NONE for method in ("height", "normal", "parallax", "steep", "occlusion")},
        "displacement: pixels of the outline that change [%]": (0.3, 5)},
    "s3-border": {"pixels of the wall, parallax over none": (1, 1), "with --bump-silhouette over without": (0.8, 0.98)},
    "s3-fig11": {"teapot with a map and --bump none vs. no map [% of pixels]": NONE, "objects": (6, 6)},
    "s3-fig12": {
        **{f"bumps on {terms}: change of the {term} term [1/255]": (1, 40) if terms in (term, "both") else NONE
           for terms in ("diffuse", "specular", "both") for term in ("diffuse", "specular")}},
    "s3-fig13": {
        "brick, mild: difference to smooth [1/255]": (4, 9.5), "brick, strong: difference to smooth [1/255]": (9.6, 20), "leather, mild: difference to smooth [1/255]": (1.5, 9),
        "leather, strong: difference to smooth [1/255]": (4, 16), "scratches, mild: difference to smooth [1/255]": (0.5, 4),
        "scratches, strong: difference to smooth [1/255]": (2, 10)},
    "s3-motion": {
        "detail of one picture, bumpy over smooth": (1.2, 1.9), "detail of one picture, strong bumps over smooth": (1.95, 6),
        "change of detail from picture to picture, bumpy over smooth": (2.6, 6), "change of detail from picture to picture, strong bumps over smooth": (2, 6),
        "mild bumps: gain from motion, factor": (1.6, 3), "strong bumps: gain from motion, factor": (0.8, 1.5), "change of detail, smooth [1/255]": (0.5, 3),
        "change of detail, bumpy [1/255]": (3.5, 10)},
    "s1-table1": {
        "a classical material: preset vs. its options one by one [1/255]": NONE, "preset vs. the programmable pipeline [1/255]": (3, 30),
        "evaluations, programmable over preset": (3, 20), "a ninth to eleventh light: change with the preset [1/255]": NONE,
        "a normal map: change with the preset [1/255]": NONE},
    "s1-oren-nayar": {
        "lambert, lit from the viewer: light at the rim over that of the middle": (0.4, 0.8),
        **{f"{model}, lit from the viewer: light at the rim over that of the middle": (0.9, 1.1) for model in ("oren-nayar", "oren-nayar-full")},
        "red over green, full over qualitative": (1.02, 1.5), "full vs. qualitative [1/255]": (0.5, 6)},
    "s1-bitangents": {
        "bitangents of their own vs. the cross product [1/255]": (1, 10), "pixels that differ [%]": (5, 40), "a square that is not sheared: pixels that differ [%]": (0, 0.01)},
    "s2-slopes": {
        "triangles": SOME, "largest difference, all visible triangles [depth key]": (0, 1e-6), "largest change of the depth key by the steps": (1e-4, 1),
        "floor, ten pixels on and six down: key minus that of the slopes [depth key]": (-1e-6, 1e-6), "floor: change of the key on that path [depth key]": (0.001, 0.2)},
    "s3-phong": {
        "a floor, viewer nearby: specular term, largest minus smallest [linear]": (0.1, 10),
        "a floor, viewer infinitely far: specular term, largest minus smallest [linear]": (0, 1e-6),
        "no ambient term, face turned away: light [linear]": NONE, "ambient term, face turned away: light [linear]": (0.002, 0.1),
        "viewer moved: change of the diffuse term [linear]": NONE,
        "viewer moved: change of the specular term [linear]": (0.1, 10), "highlight of a red sphere, red over green, lamp 0.8, 0.8, 0.3": (0.999, 1.001),
        "the same, red over blue": (2.6, 2.7), "diffuse light of a lamp at 1 m over that at 2 m": (3.9, 4.1)},
    "s1-sum": {
        "sampled pixels": SOME, "color of the engine minus the printed sum, largest [linear]": TINY, "sampled pixels brighter than 1": (1, INF),
        "the same pixels in the picture: largest code": (255, 255),
        "the same pixels in the picture: smallest red code": (255, 255), "local light, a wall added: change of the ball [linear]": NONE,
        "ball beside a red wall, local: red over green": (1, 1),
        "ball beside a red wall, path tracing: red over green": (1.02, 1.2)},
    "s1-lambert": {
        **{f"light at {degrees} degrees over light at 0": r for degrees, r in ((30, (0.866, 0.8661)), (60, (0.4999, 0.5001)), (80, (0.1736, 0.1737)))},
        "light from below": NONE, "four viewers: largest change": NONE,
        **{f"lamp at {d} m over that at 1 m, relative to the formula": (0.998, 1.002) for d in (2, 4)}},
    "s1-blinn-phong": {
        **{f"lamp ahead at 8 degrees, {model}: height of the highlight over its width": r for model, r in (("phong", (0.8, 1.2)), ("blinn-phong", (3, 6)), ("pbr", (2.3, 5)))},
        **{f"lamp beside the viewer, {model}: part of the floor with a highlight [%]": r for model, r in (("phong", (45, 70)), ("blinn-phong", (100, 100)), ("pbr", (100, 100)))}},
    "s1-pbr": {
        "white ball in even light, roughness 0.3: reflected light": (0.95, 1.01), "white ball in even light, roughness 0.9: reflected light": (0.35, 0.55),
        "the same, roughness 0.9, with multiple scattering": (0.99, 1.01), "Fresnel: black plastic seen straight on: reflected light": (0.039, 0.041),
        "Fresnel: the same at its rim over straight on": (3, 20), "Fresnel: largest difference to Schlick's formula": (0, 0.01),
        "microfacets: middle of a highlight, roughness 0.3 over 0.6": (15.5, 16.5)},
    "s1-ward": {
        **{f"{name}: height of the highlight over its width": r
           for name, r in (("widths 0.1, 0.3", (2.5, 3.5)), ("widths 0.3, 0.1", (0.28, 0.4)), ("widths 0.2, 0.2", (0.95, 1.05)), ("Blinn-Phong", (0.95, 1.05)))}},
    "s1-radiosity": {
        "room: local light and shadows vs. paths [1/255]": (40, 70), "room: radiosity vs. paths [1/255]": (2, 12),
        "floor alone: local light and shadows vs. paths [1/255]": (10, 25),
        "floor alone: radiosity vs. paths [1/255]": (2, 12), "ball's shadow on the floor, local light: mean code": (40, 90),
        "ball's shadow on the floor, radiosity: mean code": (120, 165),
        "ball's shadow on the floor, paths: mean code": (120, 165), "edge of the ball's shadow, point lamp, paths: half-lit pixels [%]": (0, 12),
        "edge of the ball's shadow, panel, paths: half-lit pixels [%]": (20, 70)},
    "s1-textures": {
        **{f"texture of {n} texels: difference to true bricks [1/255]": (27, 36) for n in (64, 128, 512)},
        "64 texels and a normal map: difference to true bricks [1/255]": (15, 25),
        "error that 64 times the texels remove [%]": (-15, 10), "error that the normal map removes [%]": (20, 50)},
    "s2-central": {
        "rays through the eye": (8, 8), "points of one ray: x and y in the box differ by up to": TINY, "the same: depth keys differ by at least": (0.1, 1),
        "the eye itself: w": NONE,
        "the eye itself: x and y": NONE, "vertices inside of the frustum": SOME, "vertices outside of it": SOME, "vertices inside of only one of frustum and box": NONE,
        "midpoints of lines: distance from the line [px]": (0, 1e-4), "midpoint of a line from 2 m to 6 m: fraction of the line in the picture": (0.749, 0.751)},
    "s2-instances": {
        "vertices compared": (8, 36), "model space: second minus first [m]": NONE, "world space: second minus the transformed model [m]": TINY,
        "first of two vs. one alone: pixels that differ [%]": NONE, "second of two, camera shifted alike, vs. one alone: pixels that differ [%]": (0, 0.05)},
    "s2-primitives": {
        **{f"{kind} vs. separate triangles: pixels that differ [%]": (0, 0.01) for kind in ("triangle strip", "triangle fan", "polygon")}, "triangles of the polygon": (4, 4),
        "line strip over line loop, pixels": (0.8, 0.9), "lines over line loop, pixels": (0.47, 0.6), "six points: pixels over the area of six discs of 9": (0.9, 1.25)},
    "s2-independent": {
        "faces in the opposite order: pixels that change [%]": (0, 0.05), **{f"{n} threads vs. one: pixels that change [%]": NONE for n in (2, 7)}},
    "s2-flat": {
        "box, Lambert, sun: flat vs. Phong shading [1/255]": NONE, "box, highlight: flat vs. Phong shading [1/255]": (0.5, 5),
        "box, lamp nearby: flat vs. Phong shading [1/255]": (4, 15),
        "sphere, Lambert, sun: flat vs. Phong shading [1/255]": (1, 5), "box: evaluations of flat shading": (6, 12), "box: evaluations, Phong over flat": (100, INF)},
    "s2-waves": {
        "bright stripes on the wall": (2, 2), "codes inside of the stripes, largest minus smallest": (0, 1), "width of a stripe over that of its slit": (0.9, 1.1),
        "all a hundred thousand times smaller: pixels that differ [%]": (0, 0.5)},
    "s3-modeled": {
        **{f"edges of {edge} cm: triangles": (n, n) for edge, n in ((16, 1024), (8, 4096), (4, 16384), (2, 65536))},
        **{f"edges of {edge} cm: difference to the finest [1/255]": r for edge, r in ((16, (26, 32)), (8, (20, 26)), (4, (11, 17)), (2, (5, 10)))},
        "normal map, 2 triangles: difference to the finest [1/255]": (20, 27), **{f"triangles, edges of {b} cm over {a} cm": (4, 4) for a, b in ((16, 8), (8, 4), (4, 2))}},
    "s3-near": {
        **{f"from {away} m: difference to displacement, of the wall's pixels [1/255]": r for away, r in (("1.2", (37, 47)), ("4.8", (32, 46)), ("19.2", (15, 36)))}},
    "s3-parallax": {"viewer 0.3 m aside: the ball at 3 m moves by [px]": (31, 35), "the ball at 6 m moves by [px]": (15, 18), "near over far": (1.9, 2.1)},
}
