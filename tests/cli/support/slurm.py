# SPDX-License-Identifier: Apache-2.0
"""A Slurm of one machine for tests: munged, slurmctld and slurmd as plain processes, with all their files in one folder. Nothing of
the system's own configuration is read or written. Linux, standard library only."""
import contextlib
import ctypes
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "scontrol", "scancel", "sinfo")
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36

CONFIG = """
ClusterName=rakelight
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
ReturnToService=2
JobRequeue=1
RequeueExit=137
KillWait=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=10 State=UP
"""


def is_installed():
    return all(shutil.which(name, path=PATH) for name in NEEDED)


def free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for s in sockets:
            s.bind(("127.0.0.1", 0))
        return [s.getsockname()[1] for s in sockets]


def descendants(of):
    """Numbers of the processes below one, by /proc."""
    below, parents = [], {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            with contextlib.suppress(OSError, ValueError, IndexError):
                stat = (entry / "stat").read_text()
                parents.setdefault(int(stat[stat.rindex(")") + 2:].split()[1]), []).append(int(entry.name))
    queue = [of]
    while queue:
        children = parents.get(queue.pop(), [])
        below += children
        queue += children
    return below


class Cluster:
    """start(), run("sbatch", ...), and stop() whatever happens: all of its processes are gone then, those of jobs too. This process
    inherits what its own children leave (prctl(2), PR_SET_CHILD_SUBREAPER), and the servers die with it."""

    def __init__(self, folder):
        self.folder, self.libc, self.log, self.servers = folder, ctypes.CDLL(None), None, []

    def start(self):
        self.libc.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        self.folder.chmod(0o755)  # munge wants to see that nobody else may write there
        controller_port, node_port = free_ports(2)
        host = socket.gethostname().split(".")[0]
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        (self.folder / "slurm.conf").write_text(CONFIG.format(
            folder=self.folder, host=host, user=user, controller_port=controller_port, node_port=node_port, cpus=os.cpu_count()))
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.environment = {**{k: v for k, v in os.environ.items() if not k.startswith(("SLURM_", "SBATCH_"))},
                            "SLURM_CONF": str(self.folder / "slurm.conf"), "PATH": PATH}
        self.log = (self.folder / "servers.log").open("wb")
        self.serve("munged", "--foreground", f"--key-file={key}", f"--socket={self.folder}/munge.socket", f"--pid-file={self.folder}/munged.pid",
                   f"--seed-file={self.folder}/munge.seed", f"--log-file={self.folder}/munged.log", "--num-threads=1", "--force")
        self.wait_for(lambda: (self.folder / "munge.socket").exists(), "munged")
        self.serve("slurmctld", "-D", "-i")
        self.serve("slurmd", "-D", "-N", host)
        self.wait_for(lambda: "idle" in self.run("sinfo", "-h", "-o", "%T", check=False), "the node")

    def serve(self, name, *options):
        def die_with_parent():
            self.libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
        self.servers.append(subprocess.Popen([shutil.which(name, path=PATH), *options], env=self.environment, cwd=self.folder,
                                             preexec_fn=die_with_parent, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log))

    def wait_for(self, is_there, what, seconds=60):
        end = time.monotonic() + seconds
        while not is_there():
            if time.monotonic() > end:
                raise TimeoutError(f"{what} did not come within {seconds} s\n{self.logs()}")
            time.sleep(0.1)

    def logs(self):
        texts = [f"{log.name}:\n" + log.read_text(errors="replace")[-3000:] for log in sorted(self.folder.glob("*.log"))]
        return "\n".join(texts)

    def run(self, *words, check=True, cwd=None):
        done = subprocess.run([str(w) for w in words], env=self.environment, cwd=cwd or self.folder, capture_output=True, text=True, timeout=60,
                              stdin=subprocess.DEVNULL)
        if check and done.returncode != 0:
            raise RuntimeError(f"{words}: {done.stdout}{done.stderr}\n{self.logs()}")
        return done.stdout

    def job(self, number):
        """What scontrol shows of a job or a task (12_1): {field: value}"""
        text = self.run("scontrol", "--oneliner", "show", "job", number).splitlines()[0]
        return dict(word.split("=", 1) for word in text.split() if "=" in word)

    def stop(self):
        for sign in (signal.SIGTERM, signal.SIGKILL):
            end = time.monotonic() + 5
            while (left := self.left()) and time.monotonic() < end:
                for number in left:
                    with contextlib.suppress(ProcessLookupError):
                        os.kill(number, sign)
                time.sleep(0.1)
        for server in self.servers:
            server.poll()
        self.libc.prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0)
        if self.log:
            self.log.close()

    def left(self):
        """Processes below this one that have not ended; those that have are taken off the system's table."""
        with contextlib.suppress(ChildProcessError):
            while os.waitpid(-1, os.WNOHANG)[0] != 0:
                pass
        return descendants(os.getpid())
