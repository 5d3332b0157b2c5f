# SPDX-License-Identifier: Apache-2.0
"""Drops files on a window as file managers do: the source of the XDND protocol, version 5
(https://www.freedesktop.org/wiki/Specifications/XDND/), and what is in the clipboard. Needs python3-xlib.

As toolkits do, the source grabs pointer and keyboard while it drags: the target sees no key of the user."""
import pathlib
import select
import sys
import time

try:
    import Xlib  # noqa: F401
except ImportError:
    sys.path.append("/usr/lib/python3/dist-packages")  # where Debian has it, whichever Python runs
try:
    from Xlib import X, XK, display
    from Xlib.ext import xtest
    from Xlib.protocol import event as events
except ImportError:
    display = None

PATIENCE = 10  # [s] for an answer of the target


def is_there():
    """Whether python3-xlib is installed."""
    return display is not None


class Refused(Exception):
    """The target takes no drop here."""


class Desktop:
    def __init__(self):
        self.display = display.Display()
        self.atom = self.display.intern_atom
        screen = self.display.screen()
        corner = screen.width_in_pixels - 1, screen.height_in_pixels - 1  # where it hides nothing that is compared
        self.window = screen.root.create_window(*corner, 1, 1, 0, X.CopyFromParent, override_redirect=True, event_mask=X.PropertyChangeMask)
        self.window.map()
        self.display.sync()

    def close(self):
        self.display.close()

    def pixels(self, width, height):
        """Rows of RGB: what the display shows in its upper left corner."""
        data = self.display.screen().root.get_image(0, 0, width, height, X.ZPixmap, 0xffffffff).data  # blue, green, red, nothing
        rgb = bytearray(3 * width * height)
        for channel in range(3):
            rgb[channel::3] = data[2 - channel::4]
        return [bytes(rgb[at:at + 3 * width]) for at in range(0, len(rgb), 3 * width)]

    def drop(self, target, files, x, y, modifiers=()):
        """Drags files to pixel x, y of the window `target` and lets go. modifiers: names of keys that are held, as "Control_L"."""
        window = self.display.create_resource_object("window", int(target))
        if window.get_full_property(self.atom("XdndAware"), X.AnyPropertyType) is None:
            raise Refused("the window is not XdndAware")
        self.uris = "".join(pathlib.Path(file).absolute().as_uri() + "\r\n" for file in files).encode()
        self.window.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)
        self.window.grab_pointer(False, X.ButtonReleaseMask, X.GrabModeAsync, X.GrabModeAsync, X.NONE, X.NONE, X.CurrentTime)
        self.window.grab_keyboard(False, X.GrabModeAsync, X.GrabModeAsync, X.CurrentTime)
        codes = [self.display.keysym_to_keycode(XK.string_to_keysym(name)) for name in modifiers]
        try:
            for code in codes:
                xtest.fake_input(self.display, X.KeyPress, code)
            self._drag(window, x, y)
        finally:
            for code in codes:
                xtest.fake_input(self.display, X.KeyRelease, code)
            self.display.ungrab_keyboard(X.CurrentTime)
            self.display.ungrab_pointer(X.CurrentTime)
            self.display.sync()

    def _drag(self, window, x, y):
        place = window.translate_coords(self.display.screen().root, 0, 0)
        root_x, root_y = x - place.x, y - place.y
        self.display.screen().root.warp_pointer(root_x, root_y)
        self._send(window, "XdndEnter", 5 << 24, self.atom("text/uri-list"), 0, 0)
        for _ in range(2):  # the pointer comes and rests
            self._send(window, "XdndPosition", 0, root_x << 16 | root_y, X.CurrentTime, self.atom("XdndActionCopy"))
            status = self._answer("XdndStatus")
        if not status[1] & 1:
            self._send(window, "XdndLeave", 0, 0, 0, 0)
            raise Refused("the window takes no drop here")
        self._send(window, "XdndDrop", 0, X.CurrentTime, 0, 0)
        if not self._answer("XdndFinished")[1]:  # GLFW sends the number of bytes, so that bit 0 alone would say nothing
            raise Refused("the window did not take what was dropped")

    def _send(self, window, name, *data):
        message = events.ClientMessage(window=window, client_type=self.atom(name), data=(32, [self.window.id, *data]))
        window.send_event(message)
        self.display.flush()

    def _answer(self, name):
        """The data of the target's next message of that name; it gets the files when it asks for them."""
        for event in self._events():
            if event.type == X.SelectionRequest:
                self._give(event)
            if event.type == X.ClientMessage and event.client_type == self.atom(name):
                return event.data[1]
        raise Refused(f"no {name} came")

    def _events(self):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if not self.display.pending_events():
                select.select([self.display], [], [], 0.05)
                continue
            yield self.display.next_event()

    def _give(self, request):
        request.requestor.change_property(request.property, request.target, 8, self.uris)
        answer = events.SelectionNotify(time=request.time, requestor=request.requestor, selection=request.selection, target=request.target, property=request.property)
        request.requestor.send_event(answer)
        self.display.flush()

    def clipboard(self):
        """Its text; none: it is empty."""
        goal = self.atom("RAKELIGHT_TEST")
        self.window.convert_selection(self.atom("CLIPBOARD"), self.atom("UTF8_STRING"), goal, X.CurrentTime)
        self.display.flush()
        for event in self._events():
            if event.type != X.SelectionNotify:
                continue
            if event.property == X.NONE:
                return None
            return self.window.get_full_property(goal, X.AnyPropertyType).value.decode()
        return None
