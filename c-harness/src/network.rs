//! A network of another problem than the arm's: the pendulum's, on observations that are recorded here.

use crate::Failure;
use crate::build::load_network;
use crate::data::Data;
use crate::line;
use crate::programs::Ran;
use crate::record::Hash;
use tpg_codegen::emit::{File, Prefix};
use tpg_codegen::policy::{QuantisedPolicy, to_c, to_words};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, Environment, SourceSet};
use tpg_problems::Pendulum;
use tpg_runtime::net::Model;

/// Test episodes that are recorded.
const EPISODES: u64 = 2;

/// Values of an observation.
const VALUES: usize = 3;

fn policy() -> Result<QuantisedPolicy, Failure> {
    load_network("c-harness/pendulum/policy.q.json")
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
    let words = to_words(&policy).map_err(Failure::new)?;
    let scratch = Model::parse(&words).map_err(|error| Failure::new(format!("{error:?}")))?.scratch();
    let mut data = Data::new("observations", "");
    data.floats("observations", &observations);
    data.rust(&format!("static WORDS: [u32; {}] = {words:?};\n", words.len()));
    data.rust(&format!("const SCRATCH: usize = {scratch};\n"));
    data.rust(&format!("const OUTPUTS: usize = {};\n", policy.values(&[0.0; VALUES]).len()));
    let prefix = "pendulum".parse::<Prefix>().map_err(Failure::new)?;
    let mut files = to_c(&policy, &prefix).map_err(Failure::new)?;
    files.extend(data.files());
    Ok(files)
}

/// Compares a firmware's answers with this machine's, and prints their cost.
pub(crate) fn check(ran: &Ran<'_>) -> Result<(), Failure> {
    let (observations, hash) = record(&policy()?);
    let count = observations.len() as u64;
    let line = line::check(ran.language, ran.lines, "answers pendulum", count, &hash)?;
    println!(
        "{}: {count} actions of the pendulum's network: the same bits as on the host, {} instructions in the mean, {} at worst",
        ran.language,
        line.number("instructions") / count,
        line.number("worst")
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{check, policy, record};
    use crate::line::Line;
    use crate::programs::Ran;

    #[test]
    fn one_other_bit_is_a_failure() {
        let (observations, hash) = record(&policy().expect("the committed network"));
        assert_eq!(observations.len(), 400);
        let checked = |hash: u64, count: usize| {
            let text = format!("answers pendulum actions=400 instructions=400 worst=1 hash={hash:016x}");
            let lines = vec![Line::parse(&text); count];
            check(&Ran { language: "C", image: "image".as_ref(), lines: &lines })
        };
        assert!(checked(hash.0, 1).is_ok());
        assert!(checked(hash.0 ^ 1, 1).is_err());
        assert!(checked(hash.0, 0).is_err());
    }
}
