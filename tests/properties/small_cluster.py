"""A Slurm cluster of three nodes on this machine, in a folder of its own, reached over the loopback only.

It needs root, because slurmd does, and Debian's packages slurmctld, slurmd, slurm-client and munge. Its key, its ports and its
state are its own: a Slurm that is installed here is not touched.
"""
import os
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

NODES = ("n1", "n2", "n3")
DAEMON_LIMIT_S = 60

CONFIGURATION = """\
ClusterName=citykiln
SlurmctldHost={host}(127.0.0.1)
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
AuthType=auth/munge
# a task that is queued again begins after cred_expire
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
SlurmUser=root
SlurmctldPort={controller_port}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
StateSaveLocation={folder}/state
SlurmdPidFile={folder}/%n.pid
SlurmdLogFile={folder}/%n.log
SlurmdSpoolDir={folder}/spool/%n
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=batch_sched_delay=0,sched_min_interval=100000,defer
# a node that does not answer is down after so long, its tasks are queued again
SlurmdTimeout={node_limit_s}
BatchStartTimeout=5
KillWait=5
MessageTimeout=10
MinJobAge=60
ReturnToService=2
{nodes}
PartitionName=batch Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """Why no cluster can run here, or None."""
    if os.geteuid() != 0:
        return "a Slurm cluster needs root"
    for program, package in (("slurmctld", "slurmctld"), ("slurmd", "slurmd"), ("sbatch", "slurm-client"), ("munged", "munge")):
        if shutil.which(program) is None:
            return f"{program} is missing (package {package})"
    return None


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class SmallCluster:
    """Starts on entry of a with statement; on exit all its processes are gone."""

    def __init__(self, folder, processors=2, node_limit_s=20):
        self.folder = Path(folder).resolve()
        self.processors, self.node_limit_s = processors, node_limit_s
        self.daemons = {}

    def __enter__(self):
        self.write_configuration()
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}
        try:
            self.start("munged")
            wait_until(lambda: (self.folder / "munge.socket").exists(), DAEMON_LIMIT_S)
            for daemon in ("slurmctld", *NODES):
                self.start(daemon)
            wait_until(lambda: self.idle_nodes() == len(NODES), DAEMON_LIMIT_S)
        except Exception:
            self.end()
            raise
        return self

    def __exit__(self, *_):
        self.end()

    def write_configuration(self):
        for name in ("state", *(f"spool/{node}" for node in NODES)):
            (self.folder / name).mkdir(parents=True)
        # munged wants every folder above its socket closed for writing, and open for reading
        self.folder.chmod(0o755)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        controller_port, *ports = free_ports(1 + len(NODES))
        host = socket.gethostname().split(".")[0]
        nodes = "\n".join(f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs={self.processors} RealMemory=64000"
                          for node, port in zip(NODES, ports))
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=host, folder=self.folder, controller_port=controller_port, node_limit_s=self.node_limit_s, nodes=nodes))

    def command_of(self, daemon):
        if daemon == "munged":
            return ["munged", "--foreground", "--force", *(f"--{name}={self.folder}/munge.{suffix}" for name, suffix in (
                ("key-file", "key"), ("socket", "socket"), ("pid-file", "pid"), ("log-file", "log"), ("seed-file", "seed")))]
        if daemon == "slurmctld":
            return ["slurmctld", "-D", "-f", str(self.folder / "slurm.conf")]
        return ["slurmd", "-D", "-N", daemon, "-f", str(self.folder / "slurm.conf")]

    def start(self, daemon):
        with open(self.folder / f"{daemon}.out", "ab") as out:
            self.daemons[daemon] = subprocess.Popen(self.command_of(daemon), env=self.environment, stdin=subprocess.DEVNULL,
                                                    stdout=out, stderr=out, start_new_session=True)

    def kill(self, daemon, signal_number=signal.SIGKILL):
        """Ends slurmctld or a node's slurmd; its tasks run on."""
        self.daemons[daemon].send_signal(signal_number)
        self.daemons[daemon].wait()

    def run(self, *command, cwd=None):
        """Runs a command of Slurm, or a script that calls them."""
        return subprocess.run([str(word) for word in command], env=self.environment, cwd=cwd, capture_output=True, text=True, check=False)

    def idle_nodes(self):
        return self.run("sinfo", "--noheader", "--Node", "--format=%t").stdout.split().count("idle")

    def state_of(self, node):
        """Such as "idle", "mixed", "down"."""
        return self.run("sinfo", "--noheader", f"--nodes={node}", "--format=%T").stdout.strip()

    def unfinished_tasks(self):
        """Lines "TASK STATE NODE" of squeue; None while the controller does not answer."""
        done = self.run("squeue", "--noheader", "--array", "--format=%i %T %N")
        return done.stdout.splitlines() if done.returncode == 0 else None

    def processes(self):
        return processes_with("SLURM_CONF", self.environment["SLURM_CONF"])

    def step_of(self, process):
        """The slurmstepd above a process, or None."""
        while process > 1:
            try:
                process = int(Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[1])
                if Path(f"/proc/{process}/comm").read_text().startswith("slurmstepd"):
                    return process
            except OSError:
                return None
        return None

    def node_of(self, task):
        """The node that a task runs on, from its environment."""
        try:
            variables = Path(f"/proc/{task}/environ").read_bytes().split(b"\0")
        except OSError:
            return None
        return next((text.decode()[len("SLURMD_NODENAME="):] for text in variables if text.startswith(b"SLURMD_NODENAME=")), None)

    def end(self):
        limit = time.monotonic() + DAEMON_LIMIT_S
        while time.monotonic() < limit and (left := self.processes()):
            for process in left:
                kill_process(process)
            time.sleep(0.1)
        for daemon in self.daemons.values():
            daemon.wait()


def processes_with(variable, value):
    """Process id to name of all processes that have this in their environment, but for this one."""
    mark = f"{variable}={value}".encode()
    found = {}
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit() or int(entry.name) == os.getpid():
            continue
        try:
            if mark in (entry / "environ").read_bytes().split(b"\0"):
                found[int(entry.name)] = (entry / "comm").read_text().strip()
        except OSError:
            continue
    return found


def kill_process(process):
    """Returns whether it was still there."""
    try:
        os.kill(process, signal.SIGKILL)
        return True
    except ProcessLookupError:
        return False


def wait_until(holds, limit_s):
    limit = time.monotonic() + limit_s
    while not holds():
        if time.monotonic() > limit:
            raise TimeoutError(f"not within {limit_s} s")
        time.sleep(0.1)
