# SPDX-License-Identifier: Apache-2.0
"""What each number may be: from, to. They hold for the pictures of the book and for the small ones of the tests, so they are as wide as the claim allows, not as
narrow as one run. A claim that did not hold has the range of what holds in its place (docs/reproduction.md says which)."""
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
        **{f"{light}, gouraud: middle less side [linear]": (-0.01, 0.01) for light in ("spot light", "highlight")},
        **{f"{light}, phong: middle less side [linear]": (0.5, INF) for light in ("spot light", "highlight")}},
    "s1-mixed": {
        "evaluations, mixed over gouraud": (1.05, INF), "evaluations, mixed over phong": (0.01, 0.95),
        "part0: places as all flat [%]": (100, 100), "part0: places as all phong [%]": (0, 60), "part2: places as all phong [%]": (100, 100), "part2: places as all flat [%]": (0, 60),
        "other parts: places as all gouraud [%]": (100, 100), "other parts: places as all phong [%]": (20, 90),
        "two spheres, gouraud: difference to phong [1/255]": (2, 6), "two spheres, auto: difference to phong [1/255]": (0.1, 1),
        "two spheres, auto: evaluations over phong": (1.001, 1.1), "two spheres, gouraud: evaluations over phong": (0.05, 0.3)},
    "s1-fig4": {"pixels whose normal leans, without the map [%]": NONE, "pixels whose normal leans, with the map [%]": (40, 95)},
    "s1-fig5": {
        "mean blue of the map [1/255]": (200, 255), "down from green to dark over down from dark to green": (1.8, INF), "difference with and without [1/255]": (10, 60)},
    "s1-fig6-8": {"places": (20, 45), "largest angle of the tangent to U [degrees]": (0, 0.1), "bitangents that go up in the texture [%]": (100, 100)},
    "s1-fig10": {
        **{f"lamp at the {lamp}, normal {name}: light of the {side} face over that with the normal in the middle": (1.05, 1.8) if lamp == "left" else (0.3, 0.93)
           for lamp in ("left", "right") for name in ("half-way", "left") for side in ("left", "right")}},
    "s1-fig13": {
        "none: normal and tangent are off a right angle [degrees]": (1.4, 5), "at the vertices: normal and tangent are off a right angle [degrees]": (0.3, 1.3),
        **{f"{way}: normal and tangent are off a right angle [degrees]": TINY for way in ("at the pixels", "at both")},
        "none, beside at the pixels [1/255]": (0.15, 0.5), "at the vertices, beside at the pixels [1/255]": (0.02, 0.14), "at both, beside at the pixels [1/255]": (0, 0.14),
        "pixels that differ by more than 10 codes, none beside at the pixels [%]": (0, 0.1)},
    "s1-routine": {
        "places": (121, 121), **{f"{what} of both [degrees]": (0, 1e-4) for what in ("normals", "tangents")}, "tangents of both, with Gram-Schmidt [degrees]": (0, 1e-4),
        "tangents with Gram-Schmidt beside those without [degrees]": (1, 5)},
    "s1-fig7": {
        **{f"{how}: normals of the evenly leaning map differ by up to [degrees]": (0, 0.01) for how in ("along u", "all turned by 50 degrees")},
        "each turned differently: normals of the evenly leaning map differ by up to [degrees]": (30, 90)},
    "s1-tangents-smoothed": {
        "normals smoothed: largest turn of the tangent from pixel to pixel [degrees]": (2, 20), "tangents, too: largest turn of the tangent from pixel to pixel [degrees]": (0.1, 1.2),
        "normals alone beside both [1/255]": (0.6, 4)},
    "s1-handedness": {
        "with the step: left half [1/255]": (0, 0.5), "with the step: mirrored half [1/255]": (12, 30), "without it, signs kept: left half [1/255]": (0, 0.5),
        "without it, signs kept: mirrored half [1/255]": (1, 9),
        **{f"{way}: axes of the mirrored half that point the wrong way": NONE for way in ("averaged tangents", "without it, signs kept")},
        **{f"{way}: axes of the mirrored half that point the wrong way": (1, 1) for way in ("with the step", "printed shader, step", "printed shader, no step")}},
    "s1-fig9-12": {
        "largest seam between objects, face [degrees]": (5, 180), "largest seam between objects, object [degrees]": (5, 180), "largest seam between objects, model [degrees]": NONE,
        "picture by face beside whole model [1/255]": (2, 10), "picture by object beside whole model [1/255]": (0.2, 1.5), "pixels that object and whole model differ in [%]": (0.5, 5),
        "objects": (6, 6)},
    "s1-stored": {"largest difference of the pictures [1/255]": NONE, "picture of the file without stored normals beside it [1/255]": (1, 6)},
    "s2-stages": {
        "stages of the lecture that have a table": (18, 18), "camera space off the lecture's formula [m]": TINY, "clip space off the projection of it [1]": TINY,
        "device space off x / w, y / w [1]": TINY, "screen off width (x + 1) / 2, height (1 - y) / 2 [px]": (0, 1e-4)},
    "s2-projection": {
        **{f"corner of the view after step 1, {axis} / -z": (0.999999, 1.000001) for axis in "xy"}, "depth of the near plane": (-1e-6, 1e-6),
        "depth of the far plane": (0.999999, 1.000001), **{f"three steps beside the engine, {what} [1]": TINY for what in ("x, y, w", "depth")},
        "all three multiplied as printed: depth of the far plane less that of the near one": (-1e-9, 1e-9)},
    "s2-parallel": {
        "parallel projection: pixels of a sphere at 6 m over those at 4 m": (0.98, 1.02), "central projection: pixels of a sphere at 6 m over those at 4 m": (0.38, 0.48),
        "parallel projection: x and y of the box over those of the camera, largest over smallest": (1, 1.0001),
        "central projection: x and y of the box over those of the camera, largest over smallest": (1.1, 3)},
    "s2-wrap-round": {"triangles through the plane of the eye": SOME, "pixels that clipping first changes [%]": (20, 100), "smallest w after clipping [m]": SOME},
    "s2-clipping": {
        "polygons cut at the four sides": SOME, "polygons wholly outside": SOME, "objects dropped whole, teapot in view": NONE, "objects dropped whole, close view of a table": SOME,
        "close view beside the middle of a wide one: pixels that differ [%]": (0, 0.05)},
    "s2-culling": {
        "faces of a closed sphere that culling drops [%]": (50, 75), "pixels of it that change [%]": NONE, "pixels of an open box that change [%]": (8, 25),
        "the box taken for clockwise, cull back, beside cull front [% of pixels]": NONE},
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
        "phong: evaluations at 320 x 240": (1300, INF), "unlit: evaluations, twice as wide and high over that": (1, 1),
        **{f"{how}: evaluations, twice as wide and high over that": (1, 1.2) for how in ("flat", "gouraud")}, "phong: evaluations, twice as wide and high over that": (3.8, 4.2),
        **{f"{how}, 4 divisions: inside, difference to faces as small as pixels [1/255]": r
           for how, r in (("unlit", (24, 32)), ("flat", (19, 23.9)), ("gouraud", (9, 18.9)), ("phong", (2, 8.9)))},
        "gouraud, 16 divisions: inside, difference to faces as small as pixels [1/255]": (3.2, 7), "phong, 16 divisions: inside, difference to faces as small as pixels [1/255]": (0.3, 3.1)},
    "s2-rays": {
        "tests of the naive loop over pixels x triangles": (1, 1), "pixels of the naive loop that differ from the tree's [%]": (0, 0.1),
        "sphere by its formula beside its triangles: pixels that differ [%]": (5, 40), "the same, triangles a hundredth as far off: pixels that differ [%]": (0, 2),
        "triangles by rays beside incremental synthesis: pixels that differ [%]": (0, 0.5),
        "reflected rays": SOME, "refracted rays": SOME, "glass and mirrors beside local light [1/255]": (25, 100), "raster: pixels that an algorithm for shadows changes [%]": (15, 60),
        "rays beside the z-buffer, cyclic overlap: pixels that differ [%]": (0, 0.5)},
    "s3-fig1": {
        "triangles, detailed over coarse": (9, INF), "coarse beside detailed [1/255]": (5, 40), "coarse with the map beside detailed [1/255]": (0.5, 10),
        "error that the map leaves [%]": (5, 75)},
    "s3-fig2-3": {
        "places": (15, 24), "normal off the mixed one of the corners [degrees]": (0, 0.001), "normals of a phong picture over those of a flat one": (4, INF),
        "flat beside phong [1/255]": (5, 20)},
    "s3-fig4": {"texture and map beside texture alone [1/255]": (2, 12), "pixels that the map changes [%]": (15, 60)},
    "s3-fig5-7": {
        **{f"{shape}: {color} at its {side}, over 128": (30, 127) if (shape == "bump") == (side in ("right side", "top")) else (-128, -30)
           for shape in ("bump", "dent") for color, sides in (("red", ("right side", "left side")), ("green", ("top", "bottom"))) for side in sides},
        "section: steep places whose red leans downhill [%]": (100, 100), "least blue of the map": (129, 255), "code 128 with zero at 127.5: leaning of the normal [degrees]": (0.1, 0.5), "code 128 with zero at 128: leaning of the normal [degrees]": NONE},
    "s3-blue": {
        "lines that warn of it": (1, 1), "normal of the part, along the face's": (-1, -0.5), "normal of the rest, along the face's": (0.99, 1),
        "light of the part over that of the rest": (0, 0.5)},
    "s3-fig8": {
        "leaning frames: pixel beside world [1/255]": (0.5, 8), "orthonormal frames: pixel beside world [1/255]": (0, 0.05),
        "leaning frames: transposed beside inverse, both at the vertices [1/255]": (0.5, 8), "faces' own frames: transposed beside inverse, both at the vertices [1/255]": (0, 0.05),
        "leaning frames: light at vertices beside world, pixels that differ [%]": (10, 50)},
    "s3-fig9": {
        **{f"{method} beside normal mapping [1/255]": (10, 50) for method in ("parallax-limited", "parallax", "steep")},
        "mean shift at 0 degrees [% of the texture]": (0.1, 0.6), "mean shift at 48 degrees [% of the texture]": (1, 1.7), "mean shift at 73 degrees [% of the texture]": (1.75, 3)},
    "s3-fig10": {
        **{f"{method} at {view} degrees: difference to displacement [1/255]": r for view, values in (
            (0, ((10, 20), (3, 9), (3, 9), (2, 8), (2, 8))), (48, ((31, 40), (25, 31), (24, 30), (8, 18), (8, 17))), (73, ((35, 45), (28, 34), (25, 34), (12, 24), (10, 22))))
           for method, r in zip(("normal", "parallax-limited", "parallax", "steep", "occlusion"), values)},
        "error at 73 degrees that parallax-limited takes away [%]": (8, 20),
        **{f"grooves {depth} deep, {method}: pixels of the floor [%]": r for depth, values in (
            ("0.06", ((35, 60), (20, 34), (5, 16), (5, 16), (5, 16))), ("0.2", ((35, 60), (6, 34), (6, 34), (0, 0.5), (0, 0.5))))
           for method, r in zip(("none", "parallax-limited", "parallax", "steep", "displacement"), values)}},
    "s3-depth": {
        **{f"depth {depth}, {method}: difference to displacement [1/255]": r for depth, values in (("0.005", (1, 5)), ("0.05", (24, 34)), ("0.12", (30, 45)))
           for method, r in zip(("normal", "parallax"), (values, values))},
        **{f"depth {depth}: parallax beside normal mapping [1/255]": r for depth, r in (("0.005", (0.5, 3)), ("0.05", (15, 28)), ("0.12", (28.5, 40)))},
        "steep: pixels that shadows of bumps change [%]": (4, 20), "normal: the same place from two sides, texture moves [% of the texture]": (0, 0.3),
        "parallax: the same place from two sides, texture moves [% of the texture]": (0.45, 4)},
    "s3-outline": {
        **{f"{method}: pixels of the outline that change [%]": NONE for method in ("height", "normal", "parallax", "steep", "occlusion")},
        "displacement: pixels of the outline that change [%]": (0.3, 5)},
    "s3-border": {"pixels of the wall, parallax over none": (1, 1), "with --bump-silhouette over without": (0.8, 0.98)},
    "s3-fig11": {"teapot with a map and --bump none beside no map [% of pixels]": NONE, "objects": (6, 6)},
    "s3-fig12": {
        **{f"bumps on {terms}: change of the {term} term [1/255]": (1, 40) if terms in (term, "both") else NONE
           for terms in ("diffuse", "specular", "both") for term in ("diffuse", "specular")}},
    "s3-fig13": {
        "brick, mild: difference to smooth [1/255]": (4, 9.5), "brick, strong: difference to smooth [1/255]": (9.6, 20), "leather, mild: difference to smooth [1/255]": (1.5, 9),
        "leather, strong: difference to smooth [1/255]": (4, 16), "scratches, mild: difference to smooth [1/255]": (0.5, 4), "scratches, strong: difference to smooth [1/255]": (2, 10)},
    "s3-motion": {
        "detail of one picture, bumpy over smooth": (1.2, 1.9), "detail of one picture, strong bumps over smooth": (1.95, 6),
        "change of detail from picture to picture, bumpy over smooth": (2.6, 6), "change of detail from picture to picture, strong bumps over smooth": (2, 6),
        "what motion adds to mild bumps, times": (1.6, 3), "what motion adds to strong bumps, times": (0.8, 1.5), "change of detail, smooth [1/255]": (0.5, 3),
        "change of detail, bumpy [1/255]": (3.5, 10)},
    "s1-table1": {
        "a classical material: preset beside its options one by one [1/255]": NONE, "preset beside the programmable pipeline [1/255]": (3, 30),
        "evaluations, programmable over preset": (3, 20), "a ninth to eleventh light: change with the preset [1/255]": NONE,
        "a normal map: change with the preset [1/255]": NONE},
    "s1-oren-nayar": {
        "lambert, lit from the viewer: light at the rim over that of the middle": (0.4, 0.8),
        **{f"{model}, lit from the viewer: light at the rim over that of the middle": (0.9, 1.1) for model in ("oren-nayar", "oren-nayar-full")},
        "red over green, full over qualitative": (1.02, 1.5), "full beside qualitative [1/255]": (0.5, 6)},
    "s1-bitangents": {
        "bitangents of their own beside the cross product [1/255]": (1, 10), "pixels that differ [%]": (5, 40), "a square that is not sheared: pixels that differ [%]": (0, 0.01)},
    "s2-slopes": {
        "triangles": SOME, "largest difference, all visible triangles [depth key]": (0, 1e-6), "largest change of the depth key by the steps": (1e-4, 1),
        "floor, ten pixels on and six down: key less the slopes' [depth key]": (-1e-6, 1e-6), "floor: change of the key on that way [depth key]": (0.001, 0.2)},
    "s3-phong": {
        "a floor, viewer nearby: specular term, largest less smallest [linear]": (0.1, 10), "a floor, viewer infinitely far: specular term, largest less smallest [linear]": (0, 1e-6),
        "no ambient term, face turned away: light [linear]": NONE, "with it: light [linear]": (0.002, 0.1), "viewer moved: change of the diffuse term [linear]": NONE,
        "viewer moved: change of the specular term [linear]": (0.1, 10), "highlight of a red sphere, red over green, lamp 0.8, 0.8, 0.3": (0.999, 1.001),
        "the same, red over blue": (2.6, 2.7), "diffuse light of a lamp at 1 m over that at 2 m": (3.9, 4.1)},
    "s1-sum": {
        "places": SOME, "color of the engine less the printed sum, largest [linear]": TINY, "places brighter than 1": (1, INF), "the same in the picture: codes, largest": (255, 255),
        "the same: red in the picture, least": (255, 255), "local light, a wall put beside: change of the ball [linear]": NONE, "ball beside a red wall, local: red over green": (1, 1),
        "ball beside a red wall, by paths: red over green": (1.02, 1.2)},
    "s1-lambert": {
        **{f"light at {degrees} degrees over light at 0": r for degrees, r in ((30, (0.866, 0.8661)), (60, (0.4999, 0.5001)), (80, (0.1736, 0.1737)))},
        "light from below": NONE, "four viewers: largest change": NONE,
        **{f"lamp at {d} m over that at 1 m, over what the attenuation says": (0.998, 1.002) for d in (2, 4)}},
    "s1-blinn-phong": {
        **{f"lamp ahead at 8 degrees, {model}: height of the highlight over its width": r for model, r in (("phong", (0.8, 1.2)), ("blinn-phong", (3, 6)), ("pbr", (2.3, 5)))},
        **{f"lamp beside the viewer, {model}: part of the floor with a highlight [%]": r for model, r in (("phong", (45, 70)), ("blinn-phong", (100, 100)), ("pbr", (100, 100)))}},
    "s1-pbr": {
        "white ball in even light, roughness 0.3: light sent back": (0.95, 1.01), "white ball in even light, roughness 0.9: light sent back": (0.35, 0.55),
        "the same, roughness 0.9, with multiple scattering": (0.99, 1.01), "Fresnel: black plastic seen straight on: light sent back": (0.039, 0.041),
        "Fresnel: the same at its rim over that": (3, 20), "Fresnel: less Schlick's formula, largest": (0, 0.01), "microfacets: middle of a highlight, roughness 0.3 over 0.6": (15.5, 16.5)},
    "s1-ward": {
        **{f"{name}: height of the highlight over its width": r
           for name, r in (("widths 0.1, 0.3", (2.5, 3.5)), ("widths 0.3, 0.1", (0.28, 0.4)), ("widths 0.2, 0.2", (0.95, 1.05)), ("Blinn-Phong", (0.95, 1.05)))}},
    "s1-radiosity": {
        "room: local light and shadows beside paths [1/255]": (40, 70), "room: radiosity beside paths [1/255]": (2, 12), "floor alone: local light and shadows beside paths [1/255]": (10, 25),
        "floor alone: radiosity beside paths [1/255]": (2, 12), "ball's shadow on the floor, local light: mean code": (40, 90), "ball's shadow on the floor, radiosity: mean code": (120, 165),
        "ball's shadow on the floor, paths: mean code": (120, 165), "edge of the ball's shadow, point lamp, paths: half-lit pixels [%]": (0, 12),
        "edge of the ball's shadow, panel, paths: half-lit pixels [%]": (20, 70)},
    "s1-textures": {
        **{f"texture of {n} texels: difference to true bricks [1/255]": (27, 36) for n in (64, 128, 512)}, "64 texels and a normal map: difference to true bricks [1/255]": (15, 25),
        "error that 64 times the texels take away [%]": (-15, 10), "error that the normal map takes away [%]": (20, 50)},
    "s2-central": {
        "rays through the eye": (8, 8), "points of one ray: x and y in the box differ by up to": TINY, "the same: depth keys differ by at least": (0.1, 1), "the eye itself: w": NONE,
        "the eye itself: x and y": NONE, "vertices inside of the frustum": SOME, "vertices outside of it": SOME, "vertices that are inside of one of frustum and box, not of the other": NONE,
        "middle points of lines: off the line [px]": (0, 1e-4), "middle of a line from 2 m to 6 m: part of the way on the picture": (0.749, 0.751)},
    "s2-instances": {
        "vertices compared": (8, 36), "model space: the second less the first [m]": NONE, "world space: the second less scale, turn and shift of the model [m]": TINY,
        "first of two beside one alone: pixels that differ [%]": NONE, "second of two, camera shifted alike, beside one alone: pixels that differ [%]": (0, 0.05)},
    "s2-primitives": {
        **{f"{kind} beside separate triangles: pixels that differ [%]": (0, 0.01) for kind in ("triangle strip", "triangle fan", "polygon")}, "triangles of the polygon": (4, 4),
        "line strip over line loop, pixels": (0.8, 0.9), "lines over line loop, pixels": (0.47, 0.6), "six points: pixels over the area of six discs of 9": (0.9, 1.25)},
    "s2-independent": {
        "faces in the opposite order: pixels that change [%]": (0, 0.05), **{f"{n} threads beside one: pixels that change [%]": NONE for n in (2, 7)}},
    "s2-flat": {
        "box, Lambert, sun: flat beside Phong shading [1/255]": NONE, "box, highlight: flat beside Phong shading [1/255]": (0.5, 5), "box, lamp nearby: flat beside Phong shading [1/255]": (4, 15),
        "sphere, Lambert, sun: flat beside Phong shading [1/255]": (1, 5), "box: evaluations of flat shading": (6, 12), "box: evaluations, Phong over flat": (100, INF)},
    "s2-waves": {
        "bright stripes on the wall": (2, 2), "codes inside of the stripes, largest less smallest": (0, 1), "width of a stripe over that of its slit": (0.9, 1.1),
        "all a hundred thousand times smaller: pixels that differ [%]": (0, 0.5)},
    "s3-modeled": {
        **{f"edges of {edge} cm: triangles": (n, n) for edge, n in ((16, 1024), (8, 4096), (4, 16384), (2, 65536))},
        **{f"edges of {edge} cm: difference to the finest [1/255]": r for edge, r in ((16, (26, 32)), (8, (20, 26)), (4, (11, 17)), (2, (5, 10)))},
        "normal map, 2 triangles: difference to the finest [1/255]": (20, 27), **{f"triangles, edges of {b} cm over {a} cm": (4, 4) for a, b in ((16, 8), (8, 4), (4, 2))}},
    "s3-near": {
        **{f"from {away} m: difference to displacement, of the wall's pixels [1/255]": r for away, r in (("1.2", (37, 47)), ("4.8", (32, 46)), ("19.2", (15, 36)))}},
    "s3-parallax": {"viewer 0.3 m aside: the ball at 3 m moves by [px]": (31, 35), "the ball at 6 m moves by [px]": (15, 18), "near over far": (1.9, 2.1)},
}
