//! Every rule of the terms, by a solver: operators applied to terms of many shapes, each result equal to what SMT-LIB says of the
//! operator. What is built here fires every rule.

mod floats;
mod wholes;
mod words;

use super::super::{Bool, Operator, Terms, Width, Word};
use super::Script;
use crate::c;
use crate::graph::Graph;
use crate::product::Effort;
use crate::proof::{Verdict, prove};
use sha2::{Digest, Sha256};
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;
use std::{env, fs};

/// Claims that a solver is to prove.
#[derive(Default)]
struct Lemmas {
    terms: Terms,
    scripts: Vec<String>,
}

impl Lemmas {
    /// A claim, of which the names of terms are filled in.
    fn claim(&mut self, claim: impl FnOnce(&mut Script<'_>) -> String) {
        let mut script = Script::new(&self.terms);
        let claim = claim(&mut script);
        script.assert(&format!("(not {claim})"));
        self.scripts.push(script.finish());
    }

    /// The claim that a node means what is written.
    fn means(&mut self, node: u32, meaning: impl FnOnce(&mut Script<'_>) -> String) {
        let mut script = Script::new(&self.terms);
        let meaning = meaning(&mut script);
        if script.meaning(&self.terms.node_at(node)) == meaning {
            return;
        }
        let name = script.name(node);
        script.assert(&format!("(not (= {name} {meaning}))"));
        self.scripts.push(script.finish());
    }

    fn truth(&mut self, term: Bool, meaning: impl FnOnce(&mut Script<'_>) -> String) {
        if term.0 & 1 == 0 {
            self.means(term.0 >> 1, meaning);
        } else {
            self.means(term.0 >> 1, |script| format!("(not {})", meaning(script)));
        }
    }
}

/// Conditions that nothing relates, and some of floats.
fn conditions(terms: &Terms) -> Vec<Bool> {
    let [x, y] = [0, 1].map(|index| terms.source(index));
    let [c, d] = [4, 6].map(|index| terms.at_most(terms.source(index), terms.source(index + 1)));
    vec![c, !c, d, terms.less(x, y), terms.is_nan(x), terms.and(c, d), !terms.and(c, !d)]
}

/// A word of 32 bits of which nothing is known.
fn opaque(terms: &Terms, index: u32) -> Word {
    let [a, b] = [index, index + 1].map(|index| terms.bits(terms.source(index)));
    terms.apply(Operator::ShiftLeft, Width::W32, a, b)
}

fn truth_values() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let all = {
        let terms = &lemmas.terms;
        let mut all = conditions(terms);
        let [c, d, less] = [all[0], all[2], all[3]];
        all.extend([Terms::TRUE, Terms::FALSE, terms.or(c, d), terms.choose(c, d, less), terms.choose(d, less, !less)]);
        all.extend([terms.all([c, d, less]), !terms.all([!c, d, less])]);
        all
    };
    for &a in &all {
        for &b in &all {
            let (both, either) = (lemmas.terms.and(a, b), lemmas.terms.or(a, b));
            lemmas.truth(both, |s| format!("(and {} {})", s.truth(a), s.truth(b)));
            lemmas.truth(either, |s| format!("(or {} {})", s.truth(a), s.truth(b)));
            for &c in &all {
                let chosen = lemmas.terms.choose(a, b, c);
                lemmas.truth(chosen, |s| format!("(ite {} {} {})", s.truth(a), s.truth(b), s.truth(c)));
                let left = lemmas.terms.restricted(a, &[b, c]);
                lemmas.claim(|s| {
                    let (a, b, c) = (s.truth(a), s.truth(b), s.truth(c));
                    format!("(=> (and {b} {c}) (= {} {a}))", s.truth(left))
                });
            }
        }
    }
    lemmas
}

/// The folder of what the solver has proven, and of what asks it.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/lemmas")
}

/// Has a solver show that no script can be satisfied. It is the Python in `TPG_SOLVER`, with bitwuzla; false if there is none.
fn refuted(subject: &str, scripts: &[String]) -> bool {
    let Some(python) = env::var_os("TPG_SOLVER") else { return false };
    let began = Instant::now();
    // what can be satisfied shows that the solver does not agree to everything
    let control = "(set-logic ALL)\n(declare-const x Float32)\n(assert (distinct x (fp.add RNE x (_ +zero 8 24))))\n";
    let place = tempfile::tempdir().expect("a folder");
    let file = place.path().join("scripts.smt2");
    fs::write(&file, [scripts, &[control.to_owned()]].concat().join(";\n")).expect("it can be written");
    let solver = Command::new(python).arg(folder().join("solve.py")).arg(file).output().expect("the solver starts");
    let answers = String::from_utf8_lossy(&solver.stdout);
    let answers: Vec<_> = answers.lines().collect();
    assert_eq!(answers.len(), scripts.len() + 1, "{}", String::from_utf8_lossy(&solver.stderr));
    for (script, &answer) in scripts.iter().zip(&answers) {
        assert_eq!(answer, "unsat", "{subject}\n{script}");
    }
    assert_eq!(answers[scripts.len()], "sat");
    println!("{subject}: {} claims proven in {:.0?}", scripts.len(), began.elapsed());
    true
}

/// Every claim is one that the solver has proven. With a solver, it proves them anew.
#[test]
fn every_rule_is_proven() {
    type Subject = (&'static str, fn() -> Lemmas);
    let subjects: [Subject; 6] = [
        ("truth values", truth_values),
        ("words of 32 bits", words::words_of_32_bits),
        ("words of 64 bits", words::words_of_64_bits),
        ("arithmetic", floats::arithmetic),
        ("comparisons", floats::comparisons),
        ("orders", floats::orders),
    ];
    let (mut text, mut all) = (String::new(), true);
    for (subject, lemmas) in subjects {
        let scripts = lemmas().scripts;
        let sum: String = Sha256::digest(scripts.concat()).iter().map(|byte| format!("{byte:02x}")).collect();
        text += &format!("{subject}: {} claims, SHA-256 {sum}\n", scripts.len());
        all &= refuted(subject, &scripts);
    }
    let place = folder().join("proven.txt");
    if all {
        fs::write(&place, &text).expect("it can be written");
    }
    let proven = fs::read_to_string(place).expect("what is proven").replace("\r\n", "\n");
    assert_eq!(text, proven, "the rules or the claims have changed; `cargo xtask lemmas` proves them anew");
}

#[test]
#[ignore = "`cargo xtask lemmas` runs it: it needs a solver"]
fn the_solver_agrees_with_proofs() {
    for policy in ["cartpole", "acrobot", "pendulum", "mountain-car-continuous", "lunar-lander"] {
        let place = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../generated").join(policy);
        let read = |name: &str| fs::read_to_string(place.join(name)).expect("a shipped file");
        let graph = Graph::read("graph.json", &read("graph.json")).expect("a graph");
        let (name, scripts) = (format!("{}.c", policy.replace('-', "_")), RefCell::new(Vec::new()));
        let code = || c::read(&place.join(&name), &read(&name), None, graph.interface());
        let proof = prove(&graph, &code, false, Effort::default(), Some(&|script| scripts.borrow_mut().push(script)));
        assert!(matches!(proof.verdict, Verdict::Proven), "{policy}: {proof}");
        assert!(refuted(policy, &scripts.take()), "no solver");
    }
}
