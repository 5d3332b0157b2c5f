#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of engine gl in a real window: they are drawn on the GPU (or by llvmpipe), beside the window's thread.

  gl_test.py PROGRAM VIEWER [unittest arguments]

Skipped as viewer_test.py is."""
import re
import sys

import support
from support import SHARED, SIZE, Case, png, wait_for

STEPS = """RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)
{
    LightTerms terms;
    real steps = floor(lambert_cosine(dot(s.diffuse_n, light.l)) * 3.0f + 0.5f) / 3.0f;
    terms.ambient = s.base.ambient * (light.ambient * light.attenuation);
    terms.diffuse = s.base.diffuse * (light.diffuse * (steps * light.attenuation));
    terms.specular = vec3(0.0f);
    return terms;
}
"""


def far_apart(a, b, most=1, columns=range(SIZE[0])):
    """The share of pixels, in these columns, whose components differ by more than `most` codes."""
    count = sum(any(abs(x - y) > most for x, y in zip(p[3 * c:3 * c + 3], q[3 * c:3 * c + 3])) for p, q in zip(a, b) if p != q for c in columns)
    return count / (len(columns) * SIZE[1])


def gl_pictures(stats):
    """How many pictures GlView drew, by --stats."""
    return int(re.search(r"(\d+) pictures by GlView", stats)[1])


class GlViewer(Case):
    def test_with_gl_the_window_shows_what_render_draws(self):
        window = self.open("parts.obj", "--engine", "gl")
        window.key("n")
        window.drag(1, 90, 40)
        window.key("s", "q")
        shown = window.settled_picture()
        path, scene = window.save()
        self.assertEqual(scene["render"]["engine"], "gl")
        self.assertLess(far_apart(shown, self.render(path)[3]), 0.001)
        self.assertTrue(png(window.screenshot()) == self.render(path))
        self.assertGreater(gl_pictures(window.close()[1]), 0)

    def test_with_gl_surfaces_hide_lines_exactly(self):
        window = self.open("parts.obj", "--engine", "gl")
        window.key("n", "9")
        plain = window.settled_picture()
        window.key("g")
        window.differs_from(plain, 500)
        gridded = window.settled_picture()
        is_red = lambda row, x: row[3 * x] > 60 and row[3 * x] > 2 * row[3 * x + 1]
        covered = [(x, y) for y in range(3, SIZE[1] - 3) for x in range(3, SIZE[0] - 3)
                   if all(is_red(plain[y + dy], x + dx) for dx in (-3, 0, 3) for dy in (-3, 0, 3))]
        self.assertGreater(len(covered), 5000)
        self.assertEqual([p for p in covered if plain[p[1]][3 * p[0]:3 * p[0] + 3] != gridded[p[1]][3 * p[0]:3 * p[0] + 3]], [])

    def test_a_split_shows_gl_beside_soft(self):
        window = self.open()
        window.key("n")
        soft = window.settled_picture()
        window.key("backslash")
        window.settled_picture()
        window.tool("mousemove", 20, 200, "click", 1)
        window.key("r")
        both = window.settled_picture()
        middle = SIZE[0] // 2
        self.assertLess(far_apart(both, soft, 2, range(middle - 9)), 0.01)
        self.assertTrue([row[3 * (middle + 9):] for row in both[40:]] == [row[3 * (middle + 9):] for row in soft[40:]])  # but for the label
        window.key("shift+backslash")  # side by side
        window.settled_picture()
        self.assertGreater(gl_pictures(window.close()[1]), 1)

    def test_a_lighting_model_is_read_again_when_its_file_changes(self):
        steps = self.folder / "steps.glsl"
        steps.write_text(STEPS)
        window = self.open("builtin:sphere", "--engine", "gl", "--lighting", "steps.glsl")
        three = window.settled_picture()
        steps.write_text(STEPS.replace("3.0f", "2.0f"))
        window.differs_from(three, 3000)
        two = window.settled_picture()
        steps.write_text(STEPS.replace("floor(", "no_such_function("))
        window.differs_from(two, 100)  # the compiler's line
        self.assertEqual(window.settled_picture()[:400], two[:400])  # texts stand below
        steps.write_text(STEPS)
        wait_for(lambda: window.picture()[:400] == three[:400], "the mended lighting model is not shown")
        self.assertEqual(window.close()[0], 0)

    def test_the_pause_of_the_window_while_gl_draws_a_real_model(self):
        helmet = SHARED / "assets" / "gltf" / "FlightHelmet" / "FlightHelmet.gltf"
        if not helmet.exists():
            self.skipTest("there is no FlightHelmet")
        window = self.open(helmet, "--engine", "gl")
        window.drag(1, 200, 40)
        window.settled_picture()
        code, stats = window.close()
        print(stats.strip(), file=sys.stderr)  # depends on the machine: reported, not judged
        self.assertEqual(code, 0)
        self.assertGreater(gl_pictures(stats), 1)


if __name__ == "__main__":
    sys.exit(support.main())
