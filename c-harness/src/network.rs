//! A network of another problem than the arm's: the pendulum's, on observations that are recorded here.

use crate::Failure;
use crate::line::Line;
use crate::record::Hash;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use tpg_codegen::emit::{File, Prefix};
use tpg_codegen::policy::{QuantisedPolicy, to_c, to_words};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, Environment, SourceSet};
use tpg_problems::Pendulum;
use tpg_runtime::net::Model;
use tpg_testing::library;

/// Test episodes that are recorded.
const EPISODES: u64 = 2;

/// Values of an observation.
const VALUES: usize = 3;

fn policy() -> Result<QuantisedPolicy, Failure> {
    let path = library::top().join("c-harness/pendulum/policy.q.json");
    let text = fs::read_to_string(&path).map_err(|error| Failure::at(&path, error))?;
    QuantisedPolicy::from_json(&path.display().to_string(), &text).map_err(Failure::new)
}

/// Lets the network act on this machine; every observation, and a hash of the bits of its answers.
fn record(policy: &QuantisedPolicy) -> (Vec<[f32; VALUES]>, Hash) {
    let (mut observations, mut hash) = (Vec::new(), Hash::new());
    for index in 0..EPISODES {
        let task = Environment::<f32>::draw(&Pendulum, &mut Stream::new(1, 0, Purpose::Evaluation, index));
        let mut swing = Environment::<f32>::start(&Pendulum, &task);
        for _ in 0..Environment::<f32>::time_limit(&Pendulum) {
            let mut state = [0f32; VALUES];
            Pendulum.observe(&mut swing, SourceSet::ALL, &mut state);
            let values = policy.values(&state);
            observations.push(state);
            values.iter().for_each(|value| hash.add(u64::from(value.to_bits())));
            Pendulum.step(&mut swing, Act::Values(&values));
        }
    }
    (observations, hash)
}

/// The packed network in C, and the observations in C and Rust, there with the packed words.
pub(crate) fn files() -> Result<Vec<File>, Failure> {
    let policy = policy()?;
    let (observations, _) = record(&policy);
    let words = to_words(&policy, false).map_err(Failure::new)?;
    let scratch = Model::parse(&words).map_err(|error| Failure::new(format!("{error:?}")))?.scratch();
    let count = observations.len();
    let mut c = format!(
        "#ifndef OBSERVATIONS_H\n#define OBSERVATIONS_H\n\n#define OBSERVATIONS {count}U\n\n\
         static const float observations[OBSERVATIONS][{VALUES}] = {{\n"
    );
    let mut rust = format!(
        "static WORDS: [u32; {}] = {words:?};\nconst SCRATCH: usize = {scratch};\nconst OUTPUTS: usize = {};\n\
         static OBSERVATIONS: [[f32; {VALUES}]; {count}] = [\n",
        words.len(),
        policy.values(&[0.0; VALUES]).len(),
    );
    for [cos, sin, omega] in observations {
        let _ = writeln!(c, "    {{ {cos:?}F, {sin:?}F, {omega:?}F }},");
        let _ = writeln!(rust, "    [{cos:?}, {sin:?}, {omega:?}],");
    }
    c.push_str("};\n\n#endif\n");
    rust.push_str("];\n");
    let prefix = "pendulum".parse::<Prefix>().map_err(Failure::new)?;
    let mut files = to_c(&policy, &prefix, false).map_err(Failure::new)?;
    let texts = [("observations.h", c), ("observations.rs", rust)];
    files.extend(texts.map(|(name, text)| File { name: name.to_owned(), text }));
    Ok(files)
}

/// Compares a firmware's answers with this machine's, and prints their cost.
pub(crate) fn compare(language: &str, image: &Path, lines: &[Line]) -> Result<(), Failure> {
    let (observations, hash) = record(&policy()?);
    let line = lines.iter().find(|line| line.words == ["actions", "pendulum"]);
    let line = line.ok_or_else(|| Failure::at(image, "no actions"))?;
    let count = observations.len() as u64;
    if line.values.get("hash") != Some(&format!("{:016x}", hash.0)) || line.number("observations") != count {
        return Err(Failure::new(format!("{language}: other actions of the pendulum's network than here: {line:?}")));
    }
    println!(
        "{language}: {count} actions of the pendulum's network: the same bits as on the host, {} instructions in the mean, {} at \
         worst",
        line.number("instructions") / count,
        line.number("worst")
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{compare, policy, record};
    use crate::line::Line;

    #[test]
    fn one_other_bit_is_a_failure() {
        let (observations, hash) = record(&policy().expect("the committed network"));
        assert_eq!(observations.len(), 400);
        let checked = |hash: u64| {
            let text = format!("actions pendulum observations=400 instructions=400 worst=1 hash={hash:016x}");
            compare("C", "image".as_ref(), &[Line::parse(&text)])
        };
        assert!(checked(hash.0).is_ok());
        assert!(checked(hash.0 ^ 1).is_err());
        assert!(compare("C", "image".as_ref(), &[]).is_err());
    }
}
