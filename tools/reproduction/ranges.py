# SPDX-License-Identifier: Apache-2.0
"""What each number may be: from, to. They are of three kinds: what theory or the claim says (exactly one number, none at all, rounding, more or less than one);
what the claim says of two numbers (ORDERS); and about() what the page has, where a claim says nothing of a size. The last kind holds for the pictures of
docs/reproduction.md and for the small ones of the tests, and guards the page against changes of the program. It says nothing of the claim. For a claim that did not
hold, the range is that of the measured result (the page lists these)."""
INF = float("inf")
NONE, SOME = (0, 0), (1e-9, INF)
TINY = (0, 1e-5)
BELOW_ONE, ABOVE_ONE = (0, 0.999), (1.001, INF)
MARGIN = 3


def about(number):
    """Within a factor of MARGIN of the number of the page."""
    return number / MARGIN, number * MARGIN


def exactly(number):
    return number, number


RANGES = {
    "s1-fig3": {
        "224 triangles, gouraud: difference to the finest [1/255]": about(15.1), "960 triangles, gouraud: difference to the finest [1/255]": about(5.75),
        "3968 triangles, gouraud: difference to the finest [1/255]": about(2.57), "224 triangles, phong: difference to the finest [1/255]": about(11.3),
        "960 triangles, phong: difference to the finest [1/255]": about(4.6), "3968 triangles, phong: difference to the finest [1/255]": about(2.36),
        "brightest pixel of 224 triangles, gouraud [1/255]": about(149), "brightest pixel of 224 triangles, phong [1/255]": about(205),
        "lighting evaluations, phong over gouraud, 224 triangles": (100, INF)},
    "s1-large-face": {
        "spot light, gouraud: middle minus side [linear]": (-0.01, 0.01), "highlight, gouraud: middle minus side [linear]": (-0.01, 0.01),
        "spot light, phong: middle minus side [linear]": (0.5, INF), "highlight, phong: middle minus side [linear]": (0.5, INF)},
    "s1-mixed": {
        "evaluations, mixed over gouraud": (1.05, INF), "evaluations, mixed over phong": (0.01, 0.95), "part0: sampled pixels equal to all flat [%]": exactly(100),
        "part0: sampled pixels equal to all phong [%]": (0, 60), "part2: sampled pixels equal to all phong [%]": exactly(100),
        "part2: sampled pixels equal to all flat [%]": (0, 60), "other parts: sampled pixels equal to all gouraud [%]": exactly(100),
        "other parts: sampled pixels equal to all phong [%]": (20, 90), "two spheres, gouraud: difference to phong [1/255]": (2, 6),
        "two spheres, auto: difference to phong [1/255]": (0.1, 1), "two spheres, auto: evaluations over phong": (1.001, 1.1),
        "two spheres, gouraud: evaluations over phong": (0.05, 0.3)},
    "s1-fig4": {"pixels with a tilted normal, without the map [%]": NONE, "pixels with a tilted normal, with the map [%]": about(70.5)},
    "s1-fig5": {
        "mean blue of the map [1/255]": (128, 255), "distance from green down to dark over dark down to green": (1.8, INF),
        "difference with and without [1/255]": about(29.1)},
    "s1-fig6-8": {"sampled pixels": about(42), "largest angle of the tangent to U [degrees]": (0, 0.1), "bitangents that go up in the texture [%]": exactly(100)},
    "s1-fig10": {
        "lamp at the left, normal half-way: light of the left face over that with the normal in the middle": ABOVE_ONE,
        "lamp at the left, normal half-way: light of the right face over that with the normal in the middle": ABOVE_ONE,
        "lamp at the left, normal left: light of the left face over that with the normal in the middle": ABOVE_ONE,
        "lamp at the left, normal left: light of the right face over that with the normal in the middle": ABOVE_ONE,
        "lamp at the right, normal half-way: light of the left face over that with the normal in the middle": BELOW_ONE,
        "lamp at the right, normal half-way: light of the right face over that with the normal in the middle": BELOW_ONE,
        "lamp at the right, normal left: light of the left face over that with the normal in the middle": BELOW_ONE,
        "lamp at the right, normal left: light of the right face over that with the normal in the middle": BELOW_ONE},
    "s1-fig13": {
        "none: error of the right angle between normal and tangent [degrees]": about(1.86),
        "at the vertices: error of the right angle between normal and tangent [degrees]": (0.3, 1.3),
        "at the pixels: error of the right angle between normal and tangent [degrees]": TINY,
        "at both: error of the right angle between normal and tangent [degrees]": TINY, "none vs. at the pixels [1/255]": about(0.207),
        "at the vertices vs. at the pixels [1/255]": (0.02, 0.14), "at both vs. at the pixels [1/255]": (0, 0.14),
        "pixels that differ by more than 10 codes, none vs. at the pixels [%]": (0, 0.1)},
    "s1-routine": {
        "sampled pixels": exactly(121), "normals of both: difference [degrees]": (0, 0.0001), "tangents of both: difference [degrees]": (0, 0.0001),
        "tangents of both with Gram-Schmidt: difference [degrees]": (0, 0.0001), "tangents with Gram-Schmidt vs. those without [degrees]": about(1.89)},
    "s1-fig7": {
        "along u: largest difference of normals, map of constant tilt [degrees]": (0, 0.01),
        "all turned by 50 degrees: largest difference of normals, map of constant tilt [degrees]": (0, 0.01),
        "each turned differently: largest difference of normals, map of constant tilt [degrees]": about(68.3)},
    "s1-tangents-smoothed": {
        "normals smoothed: largest rotation of the tangent from pixel to pixel [degrees]": (2, 20),
        "tangents smoothed, too: largest rotation of the tangent from pixel to pixel [degrees]": (0.1, 1.2), "normals alone vs. both [1/255]": (0.6, 4)},
    "s1-handedness": {
        "with the step: left half [1/255]": (0, 0.5), "with the step: mirrored half [1/255]": about(18.8), "without it, signs kept: left half [1/255]": (0, 0.5),
        "without it, signs kept: mirrored half [1/255]": (1, 9), "averaged tangents: axes of the mirrored half that point the wrong way": NONE,
        "without it, signs kept: axes of the mirrored half that point the wrong way": NONE,
        "with the step: axes of the mirrored half that point the wrong way": exactly(1),
        "printed shader, step: axes of the mirrored half that point the wrong way": exactly(1),
        "printed shader, no step: axes of the mirrored half that point the wrong way": exactly(1)},
    "s1-fig9-12": {
        **{f"{model}: largest seam between objects, {name} [degrees]": (5, 180) for model in ("Spot", "head scan") for name in ("face", "object")},
        **{f"{model}: largest seam between objects, model [degrees]": NONE for model in ("Spot", "head scan")},
        "Spot: per face vs. whole model [1/255]": about(5.36), "Spot: per object vs. whole model [1/255]": about(2.06), "Spot: objects": exactly(5),
        "head scan: per face vs. whole model [1/255]": about(3.96), "head scan: per object vs. whole model [1/255]": about(0.586), "head scan: objects": exactly(6)},
    "s1-stored": {"largest difference of the pictures [1/255]": NONE, "without stored normals vs. with them [1/255]": about(2.12)},
    "s2-stages": {
        "stages of the lecture that have a table": exactly(18), "camera space: error to the lecture's formula [m]": TINY,
        "clip space: error to the projection of camera space [1]": TINY, "device space: error to x / w, y / w [1]": TINY,
        "screen: error to width (x + 1) / 2, height (1 - y) / 2 [px]": (0, 0.0001)},
    "s2-projection": {
        "corner of the view after step 1, x / -z": (0.999999, 1.000001), "corner of the view after step 1, y / -z": (0.999999, 1.000001),
        "depth of the near plane": (-1e-06, 1e-06), "depth of the far plane": (0.999999, 1.000001), "three steps vs. the engine, x, y, w [1]": TINY,
        "three steps vs. the engine, depth [1]": TINY, "all three multiplied as printed: depth of the far plane minus that of the near one": (-1e-09, 1e-09)},
    "s2-parallel": {
        "parallel projection: pixels of a sphere at 6 m over those at 4 m": (0.98, 1.02),
        "central projection: pixels of a sphere at 6 m over those at 4 m": about(0.429),
        "parallel projection: x and y of the box over those of the camera, largest over smallest": (1, 1.0001),
        "central projection: x and y of the box over those of the camera, largest over smallest": about(1.13)},
    "s2-wrap-round": {"triangles through the plane of the eye": SOME, "pixels that clipping first changes [%]": (20, 100), "smallest w after clipping [m]": SOME},
    "s2-clipping": {
        "polygons cut at the four sides": SOME, "polygons completely outside": SOME, "objects dropped, teapot in view": NONE,
        "objects dropped, close view of a table": SOME, "close view vs. the middle of a wide one: pixels that differ [%]": (0, 0.05)},
    "s2-culling": {
        "faces of a closed sphere that culling drops [%]": (50, 75), "pixels of it that change [%]": NONE, "pixels of an open box that change [%]": (8, 25),
        "box treated as clockwise: cull back vs. cull front [% of pixels]": NONE},
    "s2-painter": {
        "cyclic overlap: pixels that the painter has wrong [%]": (0.2, 5), "crossing triangles: pixels that the painter has wrong [%]": (1, 10),
        "teapot: pixels that the painter has wrong [%]": (0.01, 1), "cyclic overlap in the opposite order: pixels that change, painter [%]": (0.5, 5),
        "cyclic overlap in the opposite order: pixels that change, z-buffer [%]": NONE},
    "s2-z-buffer": {
        "cyclic: pixels that differ, the worst of four formats [%]": (0, 0.05), "crossing: pixels that differ, the worst of four formats [%]": (0, 0.05),
        "teapot: pixels that differ, the worst of four formats [%]": (0, 0.05), "planes 2 cm apart at 20 m: pixels that z16 has wrong [%]": (5, 40),
        "planes 2 cm apart at 20 m: pixels that z24 has wrong [%]": NONE, "the same with near 0.15 m, far 40 m: pixels that z16 has wrong [%]": (1, 40),
        "the same with near 5 m, far 40 m: pixels that z16 has wrong [%]": (0, 0.1)},
    "s2-depth-precision": {
        "near [m]": exactly(1), "far [m]": exactly(1000), "depths in the first 2 % of the range [%]": (95.32, 95.34), "the same by the formula [%]": (95.32, 95.34),
        "range that 98 % of the depths reach [%]": (4.67, 4.68)},
    "s2-shading": {
        "unlit: evaluations at 320 x 240": NONE, "flat: evaluations at 320 x 240": about(955), "gouraud: evaluations at 320 x 240": about(936),
        "phong: evaluations at 320 x 240": (1300, INF), "unlit: evaluations, twice as wide and high over 320 x 240": exactly(1),
        "flat: evaluations, twice as wide and high over 320 x 240": about(1.01), "gouraud: evaluations, twice as wide and high over 320 x 240": about(1.01),
        "phong: evaluations, twice as wide and high over 320 x 240": about(4), "unlit, 4 divisions: inside, difference to faces as small as pixels [1/255]": about(28.5),
        "flat, 4 divisions: inside, difference to faces as small as pixels [1/255]": about(19.3),
        "gouraud, 4 divisions: inside, difference to faces as small as pixels [1/255]": about(15.5),
        "phong, 4 divisions: inside, difference to faces as small as pixels [1/255]": (2, 8.9),
        "gouraud, 16 divisions: inside, difference to faces as small as pixels [1/255]": about(4.71),
        "phong, 16 divisions: inside, difference to faces as small as pixels [1/255]": (0.3, 3.1)},
    "s2-rays": {
        "tests of the naive loop over pixels x triangles": exactly(1), "pixels of the naive loop that differ from the tree's [%]": (0, 0.1),
        "sphere by its formula vs. its triangles: pixels that differ [%]": (5, 40), "the same, triangles with a hundredth of the error: pixels that differ [%]": (0, 2),
        "triangles by rays vs. incremental synthesis: pixels that differ [%]": (0, 0.5), "reflected rays": SOME, "refracted rays": SOME,
        "glass and mirrors vs. local light [1/255]": about(54.7), "raster: pixels that an algorithm for shadows changes [%]": about(34.9),
        "rays vs. the z-buffer, cyclic overlap: pixels that differ [%]": (0, 0.5)},
    "s3-fig1": {
        "triangles, detailed over coarse": (9, INF), "coarse vs. detailed [1/255]": (5, 40), "coarse with the map vs. detailed [1/255]": (0.5, 10),
        "error that the map leaves [%]": (5, 75)},
    "s3-fig2-3": {
        "sampled pixels": about(24), "normal: error to the interpolated one of the corners [degrees]": (0, 0.001), "number of normals, phong over flat": (4, INF),
        "flat vs. phong [1/255]": about(10.2)},
    "s3-fig4": {
        "texture and map vs. texture alone [1/255]": about(6.55), "pixels that the map changes [%]": about(35.8),
        "detail of the head, texture and map over texture alone": (1.2, INF), "detail of the head, texture and map over that of both if independent": (0.8, 1.25)},
    "s3-fig5-7": {
        "bump: red at its right side, over 128": about(62), "bump: red at its left side, over 128": (-128, -30), "bump: green at its top, over 128": about(59),
        "bump: green at its bottom, over 128": (-128, -30), "dent: red at its right side, over 128": (-128, -30), "dent: red at its left side, over 128": about(62),
        "dent: green at its top, over 128": (-128, -30), "dent: green at its bottom, over 128": about(58),
        "section: steep texels whose red points downhill [%]": exactly(100), "smallest blue of the map": about(239),
        "code 128 with zero at 127.5: tilt of the normal [degrees]": (0.1, 0.5), "code 128 with zero at 128: tilt of the normal [degrees]": NONE},
    "s3-blue": {
        "warnings": exactly(1), "normal of the part, component along that of the face": (-1, -0.5), "normal of the rest, component along that of the face": (0.99, 1),
        "light of the part over that of the rest": (0, 0.5)},
    "s3-fig8": {
        "leaning frames: pixel vs. world [1/255]": (0.5, 8), "orthonormal frames: pixel vs. world [1/255]": (0, 0.05),
        "leaning frames: transposed vs. inverse, both at the vertices [1/255]": (0.5, 8),
        "faces' own frames: transposed vs. inverse, both at the vertices [1/255]": (0, 0.05),
        "leaning frames: light at vertices vs. world, pixels that differ [%]": about(26.6)},
    "s3-fig9": {
        "parallax-limited vs. normal mapping [1/255]": about(23.7), "parallax vs. normal mapping [1/255]": about(24.6), "steep vs. normal mapping [1/255]": (10, 50),
        "mean shift at 0 degrees [% of the texture]": (0.1, 0.6), "mean shift at 48 degrees [% of the texture]": about(1.61),
        "mean shift at 73 degrees [% of the texture]": about(1.82)},
    "s3-fig10": {
        "normal at 0 degrees: difference to displacement [1/255]": about(14.1), "parallax-limited at 0 degrees: difference to displacement [1/255]": about(4.96),
        "parallax at 0 degrees: difference to displacement [1/255]": about(4.81), "steep at 0 degrees: difference to displacement [1/255]": about(3.88),
        "occlusion at 0 degrees: difference to displacement [1/255]": about(3.57), "normal at 48 degrees: difference to displacement [1/255]": about(32.5),
        "parallax-limited at 48 degrees: difference to displacement [1/255]": about(28.9), "parallax at 48 degrees: difference to displacement [1/255]": about(28),
        "steep at 48 degrees: difference to displacement [1/255]": about(13.2), "occlusion at 48 degrees: difference to displacement [1/255]": about(12.3),
        "normal at 73 degrees: difference to displacement [1/255]": about(37.3), "parallax-limited at 73 degrees: difference to displacement [1/255]": about(32.5),
        "parallax at 73 degrees: difference to displacement [1/255]": about(30.9), "steep at 73 degrees: difference to displacement [1/255]": about(18.4),
        "occlusion at 73 degrees: difference to displacement [1/255]": about(15.7), "error at 73 degrees that parallax-limited removes [%]": about(12.8),
        "grooves 0.06 deep, none: pixels of the floor [%]": about(46.9), "grooves 0.06 deep, parallax-limited: pixels of the floor [%]": about(30.2),
        "grooves 0.06 deep, parallax: pixels of the floor [%]": about(9.38), "grooves 0.06 deep, steep: pixels of the floor [%]": about(9.38),
        "grooves 0.06 deep, displacement: pixels of the floor [%]": about(10.4), "grooves 0.2 deep, none: pixels of the floor [%]": about(46.9),
        "grooves 0.2 deep, parallax-limited: pixels of the floor [%]": (6, 34), "grooves 0.2 deep, parallax: pixels of the floor [%]": (6, 34),
        "grooves 0.2 deep, steep: pixels of the floor [%]": (0, 0.5), "grooves 0.2 deep, displacement: pixels of the floor [%]": (0, 0.5)},
    "s3-depth": {
        "depth 0.005, normal: difference to displacement [1/255]": (1, 5), "depth 0.005, parallax: difference to displacement [1/255]": about(2.65),
        "depth 0.05, normal: difference to displacement [1/255]": about(32.5), "depth 0.05, parallax: difference to displacement [1/255]": about(28),
        "depth 0.12, normal: difference to displacement [1/255]": about(40.4), "depth 0.12, parallax: difference to displacement [1/255]": about(34.2),
        "depth 0.005: parallax vs. normal mapping [1/255]": (0.5, 3), "depth 0.05: parallax vs. normal mapping [1/255]": about(24.6),
        "depth 0.12: parallax vs. normal mapping [1/255]": about(30.5), "steep: pixels that shadows of bumps change [%]": about(9.67),
        "normal: the same place from two sides, texture moves [% of the texture]": (0, 0.3),
        "parallax: the same place from two sides, texture moves [% of the texture]": (0.45, 4)},
    "s3-outline": {
        "height: pixels of the outline that change [%]": NONE, "normal: pixels of the outline that change [%]": NONE,
        "parallax: pixels of the outline that change [%]": NONE, "steep: pixels of the outline that change [%]": NONE,
        "occlusion: pixels of the outline that change [%]": NONE, "displacement: pixels of the outline that change [%]": (0.3, 5)},
    "s3-border": {"pixels of the wall, parallax over none": exactly(1), "with --bump-silhouette over without": BELOW_ONE},
    "s3-fig11": {"teapot with a map and --bump none vs. no map [% of pixels]": NONE, "objects": exactly(6)},
    "s3-fig12": {
        "bumps on diffuse: change of the diffuse term [1/255]": (1, 40), "bumps on diffuse: change of the specular term [1/255]": NONE,
        "bumps on specular: change of the diffuse term [1/255]": NONE, "bumps on specular: change of the specular term [1/255]": (1, 40),
        "bumps on both: change of the diffuse term [1/255]": (1, 40), "bumps on both: change of the specular term [1/255]": (1, 40)},
    "s3-fig13": {f"{name}, {how}: difference to smooth [1/255]": SOME for name in ("brick", "leather", "scratches") for how in ("mild", "strong")},
    "s3-motion": {
        "detail of one picture, bumpy over smooth": about(1.63), "detail of one picture, strong bumps over smooth": about(2.04),
        "change of detail from picture to picture, bumpy over smooth": about(3.14), "change of detail from picture to picture, strong bumps over smooth": about(2.59),
        "mild bumps: gain from motion, factor": about(1.92), "strong bumps: gain from motion, factor": about(1.27), "change of detail, smooth [1/255]": (0.5, 3),
        "change of detail, bumpy [1/255]": about(5.16)},
    "s1-table1": {
        "a classical material: preset vs. its options one by one [1/255]": NONE, "preset vs. the programmable pipeline [1/255]": about(13.7),
        "evaluations, programmable over preset": ABOVE_ONE, "a ninth to eleventh light: change with the preset [1/255]": NONE, "a normal map: change with the preset [1/255]": NONE,
        "control: the equation of Lambert as a text of one's own vs. the built-in one, largest difference [1/255]": (0, 1),
        "shaders: a text with three steps of light, different colors in the picture": exactly(4), "shaders: the preset alone, different colors in the picture": (20, INF)},
    "s1-oren-nayar": {
        "lambert, lit from the viewer: light at the rim over that of the middle": (0.4, 0.8),
        "oren-nayar, lit from the viewer: light at the rim over that of the middle": (0.9, 1.1),
        "oren-nayar-full, lit from the viewer: light at the rim over that of the middle": (0.9, 1.1), "red over green, full over qualitative": (1.02, 1.5),
        "full vs. qualitative [1/255]": (0.5, 6)},
    "s1-bitangents": {
        "bitangents of their own vs. the cross product [1/255]": (1, 10), "pixels that differ [%]": (5, 40),
        "a square that is not sheared: pixels that differ [%]": (0, 0.01)},
    "s2-slopes": {
        "triangles": SOME, "largest difference, all visible triangles [depth key]": (0, 1e-06), "largest change of the depth key by the steps": (0.0001, 1),
        "floor, ten pixels on and six down: key minus that of the slopes [depth key]": (-1e-06, 1e-06), "floor: change of the key on that path [depth key]": (0.001, 0.2)},
    "s3-phong": {
        "a floor, viewer nearby: specular term, largest minus smallest [linear]": (0.1, 10),
        "a floor, viewer infinitely far: specular term, largest minus smallest [linear]": (0, 1e-06), "no ambient term, face turned away: light [linear]": NONE,
        "ambient term, face turned away: light [linear]": (0.002, 0.1), "viewer moved: change of the diffuse term [linear]": NONE,
        "viewer moved: change of the specular term [linear]": (0.1, 10), "highlight of a red sphere, red over green, lamp 0.8, 0.8, 0.3": (0.999, 1.001),
        "the same, red over blue": (2.6, 2.7), "diffuse light of a lamp at 1 m over that at 2 m": (3.9, 4.1)},
    "s1-sum": {
        "sampled pixels": SOME, "color of the engine minus the printed sum, largest [linear]": TINY, "sampled pixels brighter than 1": (1, INF),
        "the same pixels in the picture: largest code": exactly(255), "the same pixels in the picture: smallest red code": exactly(255),
        "local light, a wall added: change of the ball [linear]": NONE, "ball beside a red wall, local: red over green": exactly(1),
        "ball beside a red wall, path tracing: red over green": about(1.04)},
    "s1-lambert": {
        "light at 30 degrees over light at 0": (0.866, 0.8661), "light at 60 degrees over light at 0": (0.4999, 0.5001),
        "light at 80 degrees over light at 0": (0.1736, 0.1737), "light from below": NONE, "four viewers: largest change": NONE,
        "lamp at 2 m over that at 1 m, relative to the formula": (0.998, 1.002), "lamp at 4 m over that at 1 m, relative to the formula": (0.998, 1.002)},
    "s1-blinn-phong": {
        "lamp ahead at 8 degrees, phong: height of the highlight over its width": about(0.988),
        "lamp ahead at 8 degrees, blinn-phong: height of the highlight over its width": about(4.62),
        "lamp ahead at 8 degrees, pbr: height of the highlight over its width": about(3.69),
        "lamp beside the viewer, phong: part of the floor with a highlight [%]": about(56.8),
        "lamp beside the viewer, blinn-phong: part of the floor with a highlight [%]": exactly(100),
        "lamp beside the viewer, pbr: part of the floor with a highlight [%]": exactly(100)},
    "s1-pbr": {
        "white ball in even light, roughness 0.3: reflected light": (0.95, 1.01), "white ball in even light, roughness 0.9: reflected light": (0.35, 0.55),
        "the same, roughness 0.9, with multiple scattering": (0.99, 1.01), "Fresnel: black plastic seen straight on: reflected light": (0.039, 0.041),
        "Fresnel: the same at its rim over straight on": (3, 20), "Fresnel: largest difference to Schlick's formula": (0, 0.01),
        "microfacets: middle of a highlight, roughness 0.3 over 0.6": (15.5, 16.5)},
    "s1-ward": {
        "widths 0.1, 0.3: height of the highlight over its width": (2.5, 3.5), "widths 0.3, 0.1: height of the highlight over its width": (0.28, 0.4),
        "widths 0.2, 0.2: height of the highlight over its width": (0.95, 1.05), "Blinn-Phong: height of the highlight over its width": (0.95, 1.05)},
    "s1-radiosity": {
        "room: local light and shadows vs. paths [1/255]": about(53.3), "room: radiosity vs. paths [1/255]": (2, 12),
        "floor alone: local light and shadows vs. paths [1/255]": about(17), "floor alone: radiosity vs. paths [1/255]": (2, 12),
        "ball's shadow on the floor, local light: mean code": about(63.8), "ball's shadow on the floor, radiosity: mean code": about(144),
        "ball's shadow on the floor, paths: mean code": about(143), "edge of the ball's shadow, point lamp, paths: half-lit pixels [%]": (0, 12),
        "edge of the ball's shadow, panel, paths: half-lit pixels [%]": about(25)},
    "s1-textures": {
        "texture of 64 texels: difference to true bricks [1/255]": about(30.5), "texture of 128 texels: difference to true bricks [1/255]": about(30.9),
        "texture of 512 texels: difference to true bricks [1/255]": about(32.1), "64 texels and a normal map: difference to true bricks [1/255]": about(22),
        "error that 64 times the texels remove [%]": (-15, 10), "error that the normal map removes [%]": about(28.1)},
    "s2-central": {
        "rays through the eye": exactly(8), "points of one ray: x and y in the box differ by up to": TINY, "the same: depth keys differ by at least": (0.1, 1),
        "the eye itself: w": NONE, "the eye itself: x and y": NONE, "vertices inside of the frustum": SOME, "vertices outside of it": SOME,
        "vertices inside of only one of frustum and box": NONE, "midpoints of lines: distance from the line [px]": (0, 0.0001),
        "midpoint of a line from 2 m to 6 m: fraction of the line in the picture": (0.749, 0.751)},
    "s2-instances": {
        "vertices compared": about(12), "model space: second minus first [m]": NONE, "world space: second minus the transformed model [m]": TINY,
        "first of two vs. one alone: pixels that differ [%]": NONE, "second of two, camera shifted alike, vs. one alone: pixels that differ [%]": (0, 0.05)},
    "s2-primitives": {
        "triangle strip vs. separate triangles: pixels that differ [%]": (0, 0.01), "triangle fan vs. separate triangles: pixels that differ [%]": (0, 0.01),
        "polygon vs. separate triangles: pixels that differ [%]": (0, 0.01), "triangles of the polygon": exactly(4), "line strip over line loop, pixels": (0.8, 0.9),
        "lines over line loop, pixels": (0.47, 0.6), "six points: pixels over the area of six discs of 9": (0.9, 1.25)},
    "s2-independent": {
        "faces in the opposite order: pixels that change [%]": (0, 0.05), "2 threads vs. one: pixels that change [%]": NONE,
        "7 threads vs. one: pixels that change [%]": NONE},
    "s2-flat": {
        "box, Lambert, sun: flat vs. Phong shading [1/255]": NONE, "box, highlight: flat vs. Phong shading [1/255]": (0.5, 5),
        "box, lamp nearby: flat vs. Phong shading [1/255]": about(8.64), "sphere, Lambert, sun: flat vs. Phong shading [1/255]": about(1.84),
        "box: evaluations of flat shading": about(12), "box: evaluations, Phong over flat": (100, INF)},
    "s2-waves": {
        "bright stripes on the wall": exactly(2), "codes inside of the stripes, largest minus smallest": (0, 1), "width of a stripe over that of its slit": about(1.03),
        "all a hundred thousand times smaller: pixels that differ [%]": (0, 0.5)},
    "s3-modeled": {
        "edges of 16 cm: triangles": exactly(1024), "edges of 8 cm: triangles": exactly(4096), "edges of 4 cm: triangles": exactly(16384),
        "edges of 2 cm: triangles": exactly(65536), "edges of 16 cm: difference to the finest [1/255]": about(29),
        "edges of 8 cm: difference to the finest [1/255]": about(23.4), "edges of 4 cm: difference to the finest [1/255]": about(13.6),
        "edges of 2 cm: difference to the finest [1/255]": about(7.71), "normal map, 2 triangles: difference to the finest [1/255]": about(24.1),
        "triangles, edges of 8 cm over 16 cm": exactly(4), "triangles, edges of 4 cm over 8 cm": exactly(4), "triangles, edges of 2 cm over 4 cm": exactly(4)},
    "s3-near": {
        "from 1.2 m: difference to displacement, of the wall's pixels [1/255]": about(42.3),
        "from 4.8 m: difference to displacement, of the wall's pixels [1/255]": about(42),
        "from 19.2 m: difference to displacement, of the wall's pixels [1/255]": about(31.5)},
    "s3-parallax": {"viewer 0.3 m aside: the ball at 3 m moves by [px]": (31, 35), "the ball at 6 m moves by [px]": (15, 18), "near over far": (1.9, 2.1)}}

for _ranges in RANGES.values():  # no share is above 100 %
    _ranges.update({what: (low, min(high, 100)) for what, (low, high) in _ranges.items() if what.endswith("[%]") and high < INF})


def falling(pattern, words):
    """The number of each word is below that of the word before."""
    return [(pattern.format(b), pattern.format(a)) for a, b in zip(words, words[1:])]


METHODS = ("normal", "parallax-limited", "steep")

# The first number of each pair is below the second: that is the claim.
ORDERS = {
    "s1-fig3": [*((f"{n} triangles, phong: difference to the finest [1/255]", f"{n} triangles, gouraud: difference to the finest [1/255]") for n in (224, 960, 3968)),
                *falling("{} triangles, gouraud: difference to the finest [1/255]", (224, 960, 3968)), *falling("{} triangles, phong: difference to the finest [1/255]", (224, 960, 3968)),
                ("brightest pixel of 224 triangles, gouraud [1/255]", "brightest pixel of 224 triangles, phong [1/255]")],
    "s1-fig9-12": [(f"{model}: per object vs. whole model [1/255]", f"{model}: per face vs. whole model [1/255]") for model in ("Spot", "head scan")],
    "s1-fig13": [(f"at the vertices{what}", f"none{what}") for what in (": error of the right angle between normal and tangent [degrees]", " vs. at the pixels [1/255]")],
    "s1-tangents-smoothed": [("tangents smoothed, too: largest rotation of the tangent from pixel to pixel [degrees]",
                              "normals smoothed: largest rotation of the tangent from pixel to pixel [degrees]")],
    "s1-textures": [("64 texels and a normal map: difference to true bricks [1/255]", f"texture of {n} texels: difference to true bricks [1/255]") for n in (64, 128, 512)],
    "s1-radiosity": [(f"{where}: radiosity vs. paths [1/255]", f"{where}: local light and shadows vs. paths [1/255]") for where in ("room", "floor alone")],
    "s2-shading": [*falling("{}, 4 divisions: inside, difference to faces as small as pixels [1/255]", ("unlit", "flat", "gouraud", "phong")),
                   *((f"{how}, 16 divisions: inside, difference to faces as small as pixels [1/255]", f"{how}, 4 divisions: inside, difference to faces as small as pixels [1/255]")
                     for how in ("gouraud", "phong")),
                   ("phong, 16 divisions: inside, difference to faces as small as pixels [1/255]", "gouraud, 16 divisions: inside, difference to faces as small as pixels [1/255]")],
    "s2-z-buffer": [("the same with near 0.15 m, far 40 m: pixels that z16 has wrong [%]", "planes 2 cm apart at 20 m: pixels that z16 has wrong [%]")],
    "s3-fig1": [("coarse with the map vs. detailed [1/255]", "coarse vs. detailed [1/255]")],
    "s3-fig9": [*falling("mean shift at {} degrees [% of the texture]", (73, 48, 0))],
    "s3-fig10": [pair for view in (48, 73) for pair in falling("{} at %d degrees: difference to displacement [1/255]" % view, METHODS)],
    "s3-depth": [pair for what in ("{}: parallax vs. normal mapping [1/255]", "{}, parallax: difference to displacement [1/255]")
                 for pair in falling(what, ("depth 0.12", "depth 0.05", "depth 0.005"))] + [
        ("normal: the same place from two sides, texture moves [% of the texture]", "parallax: the same place from two sides, texture moves [% of the texture]")],
    "s3-fig13": [(f"{name}, mild: difference to smooth [1/255]", f"{name}, strong: difference to smooth [1/255]") for name in ("brick", "leather", "scratches")],
    "s3-modeled": [*falling("edges of {} cm: difference to the finest [1/255]", (16, 8, 4, 2))],
    "s3-motion": [("detail of one picture, bumpy over smooth", "detail of one picture, strong bumps over smooth"),
                  ("strong bumps: gain from motion, factor", "mild bumps: gain from motion, factor"), ("change of detail, smooth [1/255]", "change of detail, bumpy [1/255]")],
}
