# SPDX-License-Identifier: Apache-2.0
"""A run of the program inside an operator: at once for scripts, in the background with Esc to cancel for buttons."""
import os
import tempfile
import time

from . import program


class RunsProgram:
    """For operators that define begin(context, source) -> arguments, finish(context, target, row) and forget()."""

    def execute(self, context):
        try:
            self.start(context)
            return self.end(context)
        except program.Failure as failure:
            return self.fail(failure)
        finally:
            self.clean()

    def invoke(self, context, event):
        try:
            self.start(context)
        except program.Failure as failure:
            self.clean()
            return self.fail(failure)
        except BaseException:
            self.clean()
            raise
        self.began = time.monotonic()
        self.timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        """Takes all events, so that nothing is edited in the meantime."""
        if event.type == "ESC":
            self.leave(context)
            self.report({"WARNING"}, "Canceled; nothing was changed")
            return {"CANCELLED"}
        if event.type != "TIMER" or not self.job.is_done():
            seconds = int(time.monotonic() - self.began)
            context.workspace.status_text_set(f"{self.bl_label}: {seconds} s. Esc: cancel")
            return {"RUNNING_MODAL"}
        try:
            return self.end(context)
        except program.Failure as failure:
            return self.fail(failure)
        finally:
            self.leave(context)

    def cancel(self, context):
        """Blender ends while the program runs."""
        self.leave(context)

    def start(self, context):
        self.job = None
        path = program.find(context)
        self.folder = tempfile.TemporaryDirectory(prefix="rakelight-")
        source = os.path.join(self.folder.name, "objects.glb")
        self.target = os.path.join(self.folder.name, "smooth.glb")
        arguments = self.begin(context, source)
        self.job = program.Smooth(path, self.folder.name, source, self.target, arguments)

    def end(self, context):
        self.finish(context, self.target, self.job.result())
        return {"FINISHED"}

    def fail(self, failure):
        self.report({"ERROR"}, str(failure))
        return {"CANCELLED"}

    def leave(self, context):
        if getattr(self, "timer", None):
            context.window_manager.event_timer_remove(self.timer)
            context.workspace.status_text_set(None)
        self.clean()

    def clean(self):
        if getattr(self, "job", None):
            self.job.stop()
        self.forget()
        if getattr(self, "folder", None):
            self.folder.cleanup()
