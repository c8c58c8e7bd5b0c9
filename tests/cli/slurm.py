"""A Slurm of one machine for tests: its own munged, slurmctld and slurmd, in a folder of their own."""

import os
import pathlib
import shutil
import socket
import subprocess
import time

PARTS = ("munged", "slurmctld", "slurmd", "sbatch", "srun", "scontrol", "squeue")
CONFIGURATION = """ClusterName=tests
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2,batch_sched_delay=0
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
KillWait=1
NodeName={host} NodeAddr=127.0.0.1 Port={node} CPUs={cpus} State=UNKNOWN
PartitionName=tests Nodes=ALL Default=YES MaxTime=INFINITE OverSubscribe=NO
"""


def missing():
    """Why no Slurm can be started here, or none."""
    if os.geteuid() != 0:
        return "slurmd needs root"
    lacking = [name for name in PARTS if not shutil.which(name, path=search_path())]
    return f"no {', '.join(lacking)}" if lacking else None


def search_path():
    return os.environ["PATH"] + ":/usr/sbin"


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Slurm:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        self.folder.chmod(0o755)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], folder=self.folder, controller=free_port(), node=free_port(),
            cpus=os.cpu_count()))
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf"), "PATH": search_path()}
        self.daemons = []

    def __enter__(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.start("munged", "--foreground", "--force", *(f"--{what}={self.folder}/munge.{end}" for what, end in (
            ("key-file", "key"), ("socket", "socket"), ("pid-file", "pid"), ("log-file", "log"), ("seed-file", "seed"))))
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D")
        self.wait("no node is ready", lambda: "idle" in self.tell("sinfo", "--noheader", "--format=%T", check=False))
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def start(self, *command):
        log = open(self.folder / f"{command[0]}.out", "w")
        self.daemons.append(subprocess.Popen(command, env=self.environment, stdout=log, stderr=log))
        log.close()

    def tell(self, *command, check=True, cwd=None):
        done = subprocess.run(list(map(str, command)), env=self.environment, cwd=cwd, capture_output=True, text=True,
                              timeout=300)
        if check and done.returncode:
            raise AssertionError(f"{command}: {done.stdout}{done.stderr}")
        return done.stdout

    def wait(self, what, until, seconds=120):
        for _ in range(10 * seconds):
            if until():
                return
            time.sleep(0.1)
        logs = "".join(f"{path.name}: {path.read_text()[-1500:]}\n" for path in self.folder.glob("slurm*.log"))
        raise AssertionError(f"{what} after {seconds} s\n{logs}")

    def submit(self, command, *options, cwd):
        """Number of the job that runs this line of a shell."""
        return self.tell("sbatch", "--parsable", *options, "--wrap", command, cwd=cwd).strip()

    def state(self, job):
        """Of all its tasks, as long as Slurm tells them."""
        return set(self.tell("squeue", "--noheader", "--states=all", "--format=%T", f"--jobs={job}", check=False).split())

    def ended(self, job):
        states = self.state(job)  # none where the controller did not answer: it keeps ended jobs for five minutes
        return bool(states) and states <= {"COMPLETED", "FAILED", "CANCELLED"}

    def wait_for(self, job):
        self.wait(f"job {job} is still there", lambda: self.ended(job))
