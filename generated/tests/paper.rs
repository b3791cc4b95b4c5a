//! Checks that the built-in description of the paper's graphs matches the runtime's arm.

use tpg_arm::WIDOWX;
use tpg_arm::binding;
use tpg_arm::observation::Source;
use tpg_graph::import::Profile;

#[test]
fn ecta24_is_the_runtimes_arm() {
    let sidecar = Profile::Ecta24.sidecar();
    let document = sidecar.document();
    let source = |declared: &tpg_graph::SourceDocument| {
        binding::source(&declared.name, declared.length as usize)
    };
    let sources: Vec<Source> = document
        .sources
        .iter()
        .map(|declared| source(declared).expect("a source of the arm"))
        .collect();
    assert_eq!(
        sources,
        [
            Source::Target,
            Source::Difference,
            Source::Hand,
            Source::Servos
        ]
    );
    for (source, declared) in sources.iter().zip(&document.sources) {
        assert_eq!(source.unit(), declared.unit);
    }
    let [.., rotation, gripper] = document.sources[3].ranges[..] else {
        panic!("six servos")
    };
    assert_eq!(
        [rotation, gripper],
        WIDOWX.fixed_servos.map(|ticks| [f64::from(ticks); 2])
    );
    for action in &document.actions {
        let effect = action.effect.as_ref().expect("an effect");
        assert!(
            binding::moved(&effect.name, &effect.values).is_some(),
            "{action:?}"
        );
    }
}
