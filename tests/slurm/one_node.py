"""A Slurm of one node in a temporary folder: munged, slurmctld and slurmd without systemd, on ports of their own."""

import os
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo")
BATCH_START_TIMEOUT, MESSAGE_TIMEOUT = 1, 5  # [s] after both, tasks unknown to a node count as lost
PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"


def missing():
    """The programs of Slurm that are not installed."""
    return [name for name in PROGRAMS if shutil.which(name, path=PATH) is None]


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class OneNode:
    def __init__(self, folder, cpus=2, memory=2000):
        self.folder = folder
        self.daemons = {}
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(folder / "slurm.conf")}
        for name in ("state", "spool"):
            (folder / name).mkdir()
        key = folder / "munge.key"
        key.touch(mode=0o600)
        key.write_bytes(os.urandom(128))
        control, node = free_ports(2)
        host, user = socket.gethostname().split(".")[0], subprocess.run(
            ["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        settings = {
            "ClusterName": "test", "SlurmctldHost": f"{host}(127.0.0.1)", "SlurmctldPort": control, "SlurmdPort": node,
            "SlurmUser": user, "SlurmdUser": user, "AuthType": "auth/munge", "AuthInfo": f"socket={folder}/munge.socket",
            "BatchStartTimeout": BATCH_START_TIMEOUT, "MessageTimeout": MESSAGE_TIMEOUT,
            "StateSaveLocation": folder / "state", "SlurmdSpoolDir": folder / "spool",
            "SlurmctldPidFile": folder / "slurmctld.pid", "SlurmdPidFile": folder / "slurmd.pid",
            "SlurmctldLogFile": folder / "slurmctld.log", "SlurmdLogFile": folder / "slurmd.log",
            "ProctrackType": "proctrack/linuxproc", "TaskPlugin": "task/none", "JobAcctGatherType": "jobacct_gather/none",
            "SelectType": "select/cons_tres", "SelectTypeParameters": "CR_CPU_Memory", "MpiDefault": "none",
            "SchedulerParameters": "batch_sched_delay=0,sched_min_interval=0,bf_interval=1", "MailProg": "/bin/true",
            "SlurmdParameters": "config_overrides", "SlurmdTimeout": 60, "ReturnToService": 2, "KillWait": 20,
        }
        lines = [f"{name}={value}" for name, value in settings.items()]
        lines += [f"NodeName=one NodeHostname={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory={memory}",
                  "PartitionName=all Nodes=ALL Default=YES DefaultTime=10 State=UP", ""]
        (folder / "slurm.conf").write_text("\n".join(lines))

    def __enter__(self):
        self.start("munged", "--foreground", "--force", f"--socket={self.folder}/munge.socket",
                   f"--key-file={self.folder}/munge.key", f"--pid-file={self.folder}/munged.pid",
                   f"--log-file={self.folder}/munged.log", f"--seed-file={self.folder}/munged.seed")
        self.wait_for(lambda: (self.folder / "munge.socket").exists(), "munged")
        self.start("slurmctld", "-D")
        self.start_node()
        return self

    def __exit__(self, *_):
        self.run("scancel", "--me", check=False)
        self.wait_for(lambda: not self.queue(), "scancel", fatal=False)
        for name in list(self.daemons)[::-1]:
            self.stop(name)

    def start(self, name, *arguments):
        with open(self.folder / f"{name}.out", "ab") as out:
            self.daemons[name] = subprocess.Popen([shutil.which(name, path=PATH), *arguments], env=self.environment,
                                                  stdin=subprocess.DEVNULL, stdout=out, stderr=out)

    def stop(self, name, how=signal.SIGTERM):
        daemon = self.daemons.pop(name, None)
        if daemon is None:
            return
        daemon.send_signal(how)
        try:
            daemon.wait(20)
        except subprocess.TimeoutExpired:
            daemon.kill()
            daemon.wait()

    def lose(self):
        """The node goes down with all that runs there, at once: a task that is stopped does not see its run end before it."""
        self.stop("slurmd", signal.SIGKILL)
        for how in (signal.SIGSTOP, signal.SIGKILL):
            for process in self.processes_of_tasks():
                try:
                    os.kill(process, how)
                except ProcessLookupError:
                    pass

    def come_back(self):
        """The node starts anew. Slurm sees that it does not know its tasks, and queues them again. The node must be up by then:
        what Slurm tells a lost node about its lost tasks arrives when that is back, and stops those that have started again.
        """
        time.sleep(BATCH_START_TIMEOUT + MESSAGE_TIMEOUT + 1)
        self.start_node()
        self.wait_for(lambda: "RUNNING" not in self.queue() and "COMPLETING" not in self.queue(), "slurmctld")
        # Requeued tasks wait two minutes. The node refuses tasks that start within the second in
        # which it was told that they are lost ("credential revoked"), which makes them fail.
        for job in set(self.run("squeue", "--noheader", "--format=%F").split()):
            self.run("scontrol", "update", f"JobId={job}", "StartTime=now+3")

    def processes_of_tasks(self):
        """Slurm's step daemons of this node, and what has this Slurm's tasks in its environment."""
        found = []
        for process in Path("/proc").iterdir():
            try:
                environment = (process / "environ").read_bytes().split(b"\0") if process.name.isdigit() else []
            except OSError:
                continue
            ours = f"SLURM_CONF={self.folder}/slurm.conf".encode() in environment
            in_task = any(one.startswith(b"SLURM_ARRAY_TASK_ID=") for one in environment)
            if ours and (in_task or (process / "comm").read_text().strip() == "slurmstepd"):
                found.append(int(process.name))
        return found

    def start_node(self):
        self.start("slurmd", "-D")
        self.wait_for(lambda: self.node_state() in ("idle", "mixed", "allocated"), "slurmd")

    def node_state(self):
        return self.run("sinfo", "--noheader", "--format=%T", check=False).strip()

    def queue(self):
        """States of the tasks that wait or run."""
        return self.run("squeue", "--array", "--noheader", "--format=%T", check=False).split()

    def run(self, *command, check=True):
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True)
        assert done.returncode == 0 or not check, done.stderr
        return done.stdout

    def wait_for(self, condition, name, seconds=60, fatal=True):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                if not fatal:
                    return
                logs = "\n".join(file.read_text(errors="replace")[-2000:] for file in self.folder.glob(f"{name}.log"))
                raise AssertionError(f"{name} is not ready after {seconds} s: {self.node_state()}, {self.queue()}\n{logs}")
            time.sleep(0.1)
