//! The examples of `--help`; a test parses each of them.

pub(super) const ALL: &str = "\
Examples:
  tpg-codegen runs/pole/graph.json --prefix pole -o out
  tpg-codegen report runs/pole/graph.json";

pub(super) const GENERATE: &str = "\
Examples:
  tpg-codegen generate graph.json --lang c --profile small -o firmware
  tpg-codegen generate graph.json --fixed 16 -o firmware
  tpg-codegen generate graph.json --explain
  tpg-codegen generate graph.json -o firmware --check";

pub(super) const VERIFY: &str = "\
Examples:
  tpg-codegen verify graph.json
  tpg-codegen verify graph.json --lang c --profile fast --states 1000000
  tpg-codegen verify policy.dot --sidecar policy.toml --expect recorded.csv";

pub(super) const PROVE: &str = "\
Examples:
  tpg-codegen prove graph.json
  tpg-codegen prove graph.json --source firmware/pole.c --certificate pole.proof.json
  tpg-codegen prove graph.json --object pole.o --symbol pole_infer";

pub(super) const REPORT: &str = "\
Examples:
  tpg-codegen report graph.json
  tpg-codegen report graph.json --target m0,esp32-c3 --fixed 16
  tpg-codegen report graph.json --target rp2040 --max-flash 4096 --max-instructions 5000";

pub(super) const CONVERT: &str = "\
Examples:
  tpg-codegen convert policy.dot --sidecar policy.toml graph.json";

pub(super) const POLICY: &str = "\
Examples:
  tpg-codegen policy policy.q.json --lang c --prefix actor -o firmware";

pub(super) const QUANTISE: &str = "\
Examples:
  tpg-codegen quantise graph.json -o whole.json
  tpg-codegen quantise graph.json --inputs 12 --weights 8 --ranges visited.csv -o whole.json
  tpg-codegen generate whole.json --lang c -o firmware";

pub(super) const PACKAGE: &str = "\
Examples:
  tpg-codegen package graph.json --for cmake --prefix arm -o arm
  tpg-codegen package graph.json --for arduino --prefix arm --author Ada -o libraries/arm
  tpg-codegen package graph.json --for cargo --prefix arm --license MIT --license-file LICENSE -o arm";

pub(super) const SCHEMA: &str = "\
Examples:
  tpg-codegen schema";

pub(super) const SIDECAR: &str = "\
Examples:
  tpg-codegen sidecar";

pub(super) const COMPLETIONS: &str = "\
Examples:
  tpg-codegen completions bash
  tpg-codegen completions zsh";

pub(super) const MAN: &str = "\
Examples:
  tpg-codegen man
  tpg-codegen man report";
