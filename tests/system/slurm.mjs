// A Slurm of one node, this machine, with daemons of its own below `folder`. Debian's slurm-wlm.

import { execFileSync, spawn, spawnSync } from "node:child_process";
import { randomBytes } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { availableParallelism, hostname, totalmem } from "node:os";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";

import { freePort } from "../store/servers.mjs";

/** Gives the environment in which `sbatch` reaches it, and `stop`; or why it does not start. */
export async function startSlurm(folder) {
  for (const part of ["state", "spool"]) mkdirSync(join(folder, part), { recursive: true });
  const host = hostname().split(".")[0];
  const at = (name) => join(folder, name);
  writeFileSync(at("munge.key"), randomBytes(1024), { mode: 0o400 });
  const megabytes = Math.floor((totalmem() / 2 ** 20) * 0.9);
  const user = execFileSync("id", ["-un"], { encoding: "utf8" }).trim();
  writeFileSync(
    at("slurm.conf"),
    `ClusterName=test
SlurmctldHost=${host}(127.0.0.1)
SlurmctldPort=${await freePort()}
SlurmdPort=${await freePort()}
SlurmUser=${user}
SlurmdUser=${user}
AuthType=auth/munge
AuthInfo=socket=${at("munge.socket")}
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
ReturnToService=2
SwitchType=switch/none
MpiDefault=none
StateSaveLocation=${at("state")}
SlurmdSpoolDir=${at("spool")}
SlurmctldPidFile=${at("slurmctld.pid")}
SlurmdPidFile=${at("slurmd.pid")}
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
NodeName=${host} NodeAddr=127.0.0.1 CPUs=${availableParallelism()} RealMemory=${megabytes} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
`,
  );
  const environment = { ...process.env, SLURM_CONF: at("slurm.conf") };
  const daemons = [
    [
      "munged",
      ["--foreground", "--force", `--key-file=${at("munge.key")}`].concat(
        [`--socket=${at("munge.socket")}`, `--pid-file=${at("munge.pid")}`],
        [`--log-file=${at("munge.log")}`, `--seed-file=${at("munge.seed")}`],
      ),
    ],
    ["slurmctld", ["-D", "-L", at("slurmctld.log")]],
    ["slurmd", ["-D", "-N", host, "-L", at("slurmd.log")]],
  ].map(([program, words]) =>
    spawn(program, words, {
      env: { ...environment, PATH: `${process.env.PATH}:/usr/sbin` },
      stdio: "ignore",
    }).on("error", () => {}),
  );
  const stop = async () => {
    for (const daemon of daemons.reverse()) {
      if (daemon.exitCode !== null || daemon.pid === undefined) continue;
      const gone = new Promise((done) => daemon.on("exit", done));
      daemon.kill("SIGTERM");
      await gone;
    }
  };
  for (let i = 0; i < 150; ++i) {
    const nodes = spawnSync("sinfo", ["--noheader", "--format=%t"], {
      env: environment,
      encoding: "utf8",
    });
    if (nodes.status === 0 && nodes.stdout.trim() === "idle") return { environment, stop };
    await pause(200);
  }
  await stop();
  const said = ["munge.log", "slurmctld.log", "slurmd.log"].map((name) => {
    try {
      return readFileSync(at(name), "utf8").split("\n").slice(-4).join("\n");
    } catch {
      return `no ${name}`;
    }
  });
  return { why: `Slurm does not start here:\n${said.join("\n")}` };
}
