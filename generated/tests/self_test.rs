//! The self-test of the shipped C notices constants that a compiler, a linker or an editor changed.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Puts a factor beside each constant of the decision, and returns the code with the number of factors. They are 1 at first.
fn with_factors(code: &str, prefix: &str) -> (String, usize) {
    let begin = code
        .find(&format!("{prefix}_infer(const"))
        .expect("the decision");
    let end = code.find("#ifndef").filter(|&end| end > begin);
    let end = end
        .or_else(|| code[begin..].find("#ifndef").map(|at| begin + at))
        .expect("the self-test");
    let mut count = 0;
    let mut body = String::new();
    let mut word = String::new();
    for c in code[begin..end].chars() {
        if c.is_ascii_alphanumeric()
            || c == '_'
            || c == '.'
            || (matches!(c, '+' | '-') && word.ends_with("e") && is_number(&word))
        {
            word.push(c);
            continue;
        }
        if is_number(&word)
            && word.ends_with('f')
            && word
                .trim_end_matches('f')
                .parse::<f32>()
                .is_ok_and(|value| value != 0.0)
        {
            let _ = write!(body, "({word} * factor[{count}])");
            count += 1;
        } else {
            body.push_str(&word);
        }
        word.clear();
        body.push(c);
    }
    let line = code[..begin].rfind('\n').map_or(0, |at| at + 1);
    let factors = format!("static volatile float factor[{}];\n", count.max(1));
    (
        format!(
            "{}{factors}{}{body}{}",
            &code[..line],
            &code[line..begin],
            &code[end..]
        ),
        count,
    )
}

fn is_number(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_digit())
}

/// Returns how many constants the self-test notices if each is a hundredth larger, and how many there are.
fn noticed(name: &str, prefix: &str) -> [usize; 2] {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    let code = fs::read_to_string(folder.join(format!("{prefix}.c"))).expect("the shipped C");
    let (code, count) = with_factors(&code, prefix);
    let main = format!(
        "\n#include <stdio.h>\nint main(void)\n{{\n    int noticed = 0;\n    for (int i = 0; i < {count}; i++) factor[i] = 1.0f;\n    \
         if ({prefix}_selftest() != 0U) return 1;\n    for (int i = 0; i < {count}; i++) {{\n        factor[i] = 1.01f;\n        \
         noticed += {prefix}_selftest() != 0U;\n        factor[i] = 1.0f;\n    }}\n    printf(\"%d\", noticed);\n    return 0;\n}}\n"
    );
    let room = tempfile::tempdir().expect("a temporary folder");
    let [source, program] = ["changed.c", "changed"].map(|name| room.path().join(name));
    fs::write(&source, code + &main).expect("it can be written");
    let built = Command::new("gcc")
        .args(["-std=c11", "-O1", "-I"])
        .args([&folder, &source])
        .arg("-o")
        .arg(&program)
        .output();
    let built = built.expect("gcc runs");
    assert!(
        built.status.success(),
        "{name}: {}",
        String::from_utf8_lossy(&built.stderr)
    );
    let said = Command::new(&program).output().expect("it runs");
    assert!(
        said.status.success(),
        "{name}: the code that is not changed passes"
    );
    [
        String::from_utf8_lossy(&said.stdout)
            .parse()
            .expect("a number"),
        count,
    ]
}

#[test]
fn a_self_test_notices_changed_constants() {
    if !tpg_testing::tool("gcc", "gcc", "changed constants of the shipped C") {
        return;
    }
    for (name, share) in [
        ("acrobot", 100),
        ("bipedal-walker", 100),
        ("cartpole", 100),
        ("half-cheetah", 100),
        ("hopper", 100),
        ("inverted-double-pendulum", 100),
        ("lunar-lander", 100),
        ("lunar-lander-continuous", 100),
        ("mountain-car", 66),
        ("mountain-car-continuous", 50),
        ("pendulum", 100),
        ("swimmer", 100),
    ] {
        let [noticed, count] = noticed(name, &name.replace('-', "_"));
        println!("{name}: {noticed} of {count}");
        assert!(
            100 * noticed >= share * count,
            "{name}: {noticed} of {count} constants are noticed"
        );
    }
}
