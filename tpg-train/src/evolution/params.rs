//! GEGELATI's `params.json` as settings: its parameters have the same names here, in snake case.

use tpg_graph::error::{InputError, Place};

/// The preset that a `params.json` holds differences from.
pub(super) const PRESET: &str = "gegelati";

/// GEGELATI's names of the settings.
const SETTINGS: [(&str, &str); 13] = [
    ("initNbRoots", "tpg.init_nb_roots"),
    ("nbIterationsPerPolicyEvaluation", "learning.nb_iterations_per_policy_evaluation"),
    ("ratioDeletedRoots", "learning.ratio_deleted_roots"),
    ("nbGenerations", "learning.nb_generations"),
    ("maxNbEvaluationPerPolicy", "learning.max_nb_evaluation_per_policy"),
    ("nbRegisters", "learning.nb_registers"),
    ("nbRoots", "tpg.nb_roots"),
    ("maxInitOutgoingEdges", "tpg.max_init_outgoing_edges"),
    ("maxOutgoingEdges", "tpg.max_outgoing_edges"),
    ("pEdgeDestinationChange", "tpg.p_edge_destination_change"),
    ("pEdgeDestinationIsAction", "tpg.p_edge_destination_is_action"),
    ("maxProgramSize", "program.max_program_size"),
    ("pSwap", "program.p_swap"),
];

/// Parameters that are no settings, with the value that they have here.
const CONSTANTS: [(&str, f64); 7] = [
    ("pAdd", 0.5),
    ("pDelete", 0.5),
    ("pMutate", 1.0),
    ("pEdgeAddition", 0.7),
    ("pEdgeDeletion", 0.7),
    ("pProgramMutation", 0.2),
    ("nbProgramConstant", 0.0),
];

/// Parameters that change no result here.
const WITHOUT_EFFECT: [&str; 3] = ["nbThreads", "doValidation", "nbIterationsPerJob"];

/// Tests for JSON, with comments as GEGELATI writes it: no TOML begins so.
pub(super) fn is_json(text: &str) -> bool {
    ["{", "//", "/*"].iter().any(|start| text.trim_start().starts_with(start))
}

/// Reads a `params.json`; a note names the parameters that have no counterpart.
///
/// # Errors
/// If it is not JSON, or holds none of GEGELATI's parameters.
pub(super) fn settings(file: &str, text: &str) -> Result<toml::Table, InputError> {
    let (settings, ignored) = translated(file, text)?;
    if !ignored.is_empty() {
        tpg_graph::command::note(format_args!("{file}: without effect here: {}", ignored.join(", ")));
    }
    Ok(settings)
}

fn translated(file: &str, text: &str) -> Result<(toml::Table, Vec<String>), InputError> {
    let accepted = "a params.json of GEGELATI";
    let json: serde_json::Value = serde_json::from_str(&without_comments(text))
        .map_err(|error| InputError::new(file, Place::Line(error.line()), error.to_string(), accepted))?;
    let (mut settings, mut ignored) = (toml::Table::new(), Vec::new());
    let mut set = |key: &str, value: toml::Value| {
        let (section, name) = key.split_once('.').unwrap_or(("", key));
        let section = settings.entry(section).or_insert_with(|| toml::Table::new().into());
        section.as_table_mut().map(|section| section.insert(name.to_owned(), value));
    };
    let mut open = vec![&json];
    while let Some(serde_json::Value::Object(object)) = open.pop() {
        for (name, value) in object {
            if value.is_object() {
                open.push(value);
                continue;
            }
            let constant = CONSTANTS.iter().find(|(constant, _)| constant == name);
            if let Some((_, key)) = SETTINGS.iter().find(|(setting, _)| setting == name) {
                let value = toml::Value::try_from(value)
                    .map_err(|_| InputError::new(file, Place::Path(name.clone()), value.to_string(), "a number"))?;
                // 0 says that it follows from the number of roots.
                if value.as_integer() != Some(0) || name != "initNbRoots" {
                    set(key, value);
                }
            } else if !WITHOUT_EFFECT.contains(&name.as_str())
                && constant.is_none_or(|(_, here)| value.as_f64() != Some(*here))
            {
                let here = constant.map_or_else(|| "not known here".to_owned(), |(_, here)| format!("here {here}"));
                ignored.push(format!("{name} = {value}, {here}"));
            }
        }
    }
    if let Some(toml::Value::Table(tpg)) = settings.get_mut("tpg")
        && let (Some(roots), None) = (tpg.get("nb_roots").cloned(), tpg.get("init_nb_roots"))
    {
        tpg.insert("init_nb_roots".to_owned(), roots);
    }
    if settings.is_empty() {
        return Err(InputError::new(file, Place::Whole, "JSON without a parameter of GEGELATI", accepted));
    }
    ignored.sort();
    Ok((settings, ignored))
}

/// Returns JSON without its comments, each line in its place.
fn without_comments(text: &str) -> String {
    let (mut plain, mut rest) = (String::new(), text);
    while let Some(next) = rest.chars().next() {
        let taken = if next == '"' {
            let mut is_escaped = false;
            let end = rest[1..].find(|letter| {
                let ends = letter == '"' && !is_escaped;
                is_escaped = letter == '\\' && !is_escaped;
                ends
            });
            let taken = end.map_or(rest.len(), |end| end + 2);
            plain.push_str(&rest[..taken]);
            taken
        } else if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            let taken = rest.find("*/").map_or(rest.len(), |end| end + 2);
            plain.extend(rest[..taken].chars().filter(|&letter| letter == '\n'));
            taken
        } else {
            plain.push(next);
            next.len_utf8()
        };
        rest = &rest[taken..];
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::{is_json, translated};

    const PARAMS: &str = r#"{
    // Number of recordings. "archiveSize" : 50, // Default value
    "archiveSize" : 2000,
    "archivingProbability" : 0.01, "doValidation" : true, /* "nbThreads" : 2,
    */ "note" : "a // b \" /* c */",
    "mutation" : { "prog" : { "maxProgramSize" : 20, "pAdd" : 0.5 }, "tpg" : { "nbRoots" : 150, "pEdgeDestinationChange" : 0.25 } },
    "selection" : { "truncation" : { "ratioDeletedRoots" : 0.9 } }
}"#;

    #[test]
    fn parameters_become_settings_and_others_are_named() {
        assert!(is_json(PARAMS) && is_json("// a comment\n{}") && !is_json("[tpg]\n") && !is_json("# x\n"));
        let (settings, ignored) = translated("params.json", PARAMS).expect("parameters");
        let expected: toml::Table = "
            learning.ratio_deleted_roots = 0.9
            program.max_program_size = 20
            tpg = { nb_roots = 150, init_nb_roots = 150, p_edge_destination_change = 0.25 }
        "
        .parse()
        .expect("TOML");
        assert_eq!(settings, expected);
        assert_eq!(
            ignored,
            [
                "archiveSize = 2000, not known here",
                "archivingProbability = 0.01, not known here",
                r#"note = "a // b \" /* c */", not known here"#
            ]
        );
    }

    #[test]
    fn the_first_number_of_roots_follows_from_the_other_if_it_is_not_given() {
        for (first, expected) in [("", 5), (", \"initNbRoots\": 0", 5), (", \"initNbRoots\": 9", 9)] {
            let (settings, _) = translated("params.json", &format!("{{\"nbRoots\": 5{first}}}")).expect("parameters");
            assert_eq!(settings["tpg"]["init_nb_roots"].as_integer(), Some(expected), "{first}");
        }
    }

    #[test]
    fn what_is_no_params_json_is_refused_with_its_line() {
        let error = translated("params.json", "{\n// a\n\"nbRoots\" : ,\n}").expect_err("no value").to_string();
        assert!(error.starts_with("params.json: line 3: "), "{error}");
        let error = translated("params.json", "{\"a\": 1}").expect_err("no parameter").to_string();
        assert!(error.contains("JSON without a parameter of GEGELATI"), "{error}");
    }
}
