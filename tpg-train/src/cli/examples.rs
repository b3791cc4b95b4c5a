//! The examples of `--help`; a test parses each of them.

pub(super) const ALL: &str = "\
Examples:
  tpg-train problems
  tpg-train tpg --problem cartpole --target 475 --out runs/pole
  tpg-train report runs/pole";

pub(super) const PROBLEMS: &str = "\
Examples:
  tpg-train problems";

pub(super) const TPG: &str = "\
Examples:
  tpg-train tpg --problem cartpole --target 475 --out runs/pole
  tpg-train tpg --problem pendulum --seeds 1..6 --out runs/pendulum
  tpg-train tpg --problem cartpole --preset quick --set tpg.nb_roots=40 --max-steps 1000000 --out runs/quick
  tpg-train tpg --config my.toml --generations 400 --out runs/mine --resume";

pub(super) const SAC: &str = "\
Examples:
  tpg-train sac --problem pendulum --out runs/sac";

pub(super) const HYBRID: &str = "\
Examples:
  tpg-train hybrid --problem rs --tpg runs/graph/graph.json --policy runs/sac/policy.safetensors --out runs/study";

pub(super) const IMPORT: &str = "\
Examples:
  tpg-train import actor.safetensors --problem pendulum --out policy.safetensors";

pub(super) const QUANTISE: &str = "\
Examples:
  tpg-train quantise runs/sac/policy.safetensors --out policy.q.json";

pub(super) const EVAL: &str = "\
Examples:
  tpg-train eval --problem cartpole --tpg runs/pole/graph.json
  tpg-train eval --problem fs --policy planner --episodes 100 --json";

pub(super) const REPORT: &str = "\
Examples:
  tpg-train report runs/pole runs/pendulum --out report.html";

pub(super) const CONFIG: &str = "\
Examples:
  tpg-train config quick
  tpg-train config --list";

pub(super) const ARM: &str = "\
Examples:
  tpg-train arm import so101.urdf --tip gripper_frame_link --fix wrist_roll=0 -o arm.toml";

pub(super) const TARGETS: &str = "\
Examples:
  tpg-train targets --problem rs";

pub(super) const COMPLETIONS: &str = "\
Examples:
  tpg-train completions bash
  tpg-train completions fish";

pub(super) const MAN: &str = "\
Examples:
  tpg-train man
  tpg-train man tpg";
