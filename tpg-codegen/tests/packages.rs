//! Packages of every ecosystem, built by a user's project outside of the repository.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;
use tpg_testing::library::top;
use tpg_testing::{exists, skip, tool};

use crate::common::run;

/// Graphs that answer with an action, with a value, with a value and memory, and [in counts](IN_COUNTS).
const GRAPHS: [(&str, &str); 4] = [
    ("cartpole", "generated/cartpole/graph.json"),
    ("pendulum", "generated/pendulum/graph.json"),
    ("recall", "c-harness/pendulum/recall.json"),
    (IN_COUNTS, "generated/pendulum/graph.json"),
];
/// The graph that is first put into integers.
const IN_COUNTS: &str = "counted";

fn codegen() -> assert_cmd::Command {
    assert_cmd::Command::cargo_bin("tpg-codegen").expect("the program is built")
}

/// Packages every graph for an ecosystem, in folders of their names.
fn packed(ecosystem: &str) -> TempDir {
    let folder = TempDir::new().expect("a temporary folder");
    for (name, graph) in GRAPHS {
        let mut file = top().join(graph);
        if name == IN_COUNTS {
            let whole = folder.path().join("whole.json");
            codegen().arg("quantise").arg(&file).arg("-o").arg(&whole).assert().success();
            file = whole;
        }
        let mut command = codegen();
        command.current_dir(folder.path()).args(["package", "--for", ecosystem, "-o", name, "--no-verify"]);
        command.args(["--prefix", name]).arg(&file).assert().success();
        let readme = read(&folder.path().join(name).join("README.md"));
        assert!(readme.contains("SHA-256") && readme.contains("of flash") && readme.contains("MIT OR Apache-2.0"));
        assert!(read(&folder.path().join(name).join("LICENSE-MIT")).contains("Permission is hereby granted"));
    }
    folder
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a folder")).expect("the folder can be made");
    fs::write(path, text).expect("the folder can be written");
}

fn good(command: &mut Command) -> String {
    run(command).unwrap_or_else(|text| panic!("{text}"))
}

/// A program that asks every policy for its self-test.
fn main_c() -> String {
    let includes: String = GRAPHS.iter().map(|(name, _)| format!("#include \"{name}.h\"\n")).collect();
    let sum: Vec<String> = GRAPHS.iter().map(|(name, _)| format!("{name}_selftest()")).collect();
    format!("{includes}int main(void)\n{{\n    return (({}) == 0U) ? 0 : 1;\n}}\n", sum.join(" + "))
}

#[test]
fn cmake_fetches_and_finds() {
    if !tool("cmake", "cmake", "packages for CMake") || !tool("gcc", "gcc", "packages for CMake") {
        return;
    }
    let folder = packed("cmake");
    let place = |name: &str| folder.path().join(name);
    let cmake = |words: &[&str]| {
        let mut command = Command::new("cmake");
        command.current_dir(folder.path()).args(words);
        command
    };
    let names = GRAPHS.map(|(name, _)| name);
    let link = names.map(|name| format!("{name}::{name}")).join(" ");
    let project = |before: &str| {
        format!(
            "cmake_minimum_required(VERSION 3.16)\nproject(user C)\n{before}add_executable(main main.c)\n\
             target_link_libraries(main PRIVATE {link})\n"
        )
    };
    // As a part of the user's build.
    let fetch = names.map(|name| {
        format!(
            "FetchContent_Declare({name} SOURCE_DIR {})\nFetchContent_MakeAvailable({name})\n",
            place(name).display()
        )
    });
    let examples =
        "set(CARTPOLE_EXAMPLES ON)\nset(PENDULUM_EXAMPLES ON)\nset(RECALL_EXAMPLES ON)\nset(COUNTED_EXAMPLES ON)\n";
    let policy = "set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)\ninclude(FetchContent)\n";
    write(&place("fetches/CMakeLists.txt"), &project(&format!("{policy}{examples}{}", fetch.concat())));
    write(&place("fetches/main.c"), &main_c());
    good(&mut cmake(&["-S", "fetches", "-B", "fetches/build"]));
    good(&mut cmake(&["--build", "fetches/build"]));
    good(&mut Command::new(place("fetches/build/main")));
    for name in names {
        let example = place(&format!("fetches/build/_deps/{name}-build/{name}_decide"));
        assert!(good(&mut Command::new(example)).starts_with("self-test: 0 wrong\n"), "{name}");
    }
    // Installed.
    let prefix = format!("-DCMAKE_INSTALL_PREFIX={}", place("prefix").display());
    for name in names {
        let build = format!("{name}/build");
        good(&mut cmake(&["-S", name, "-B", &build, &prefix]));
        good(&mut cmake(&["--build", &build, "--target", "install"]));
    }
    let find = |version: &str| names.map(|name| format!("find_package({name} {version} CONFIG REQUIRED)\n")).concat();
    let path = format!("-DCMAKE_PREFIX_PATH={}", place("prefix").display());
    write(&place("finds/main.c"), &main_c());
    for (version, found) in [("0.1", true), ("0.2", false)] {
        write(&place("finds/CMakeLists.txt"), &project(&find(version)));
        let said = run(&mut cmake(&["-S", "finds", "-B", "finds/build", &path]));
        assert_eq!(said.is_ok(), found, "{version}: {said:?}");
        if found {
            good(&mut cmake(&["--build", "finds/build"]));
            good(&mut Command::new(place("finds/build/main")));
        }
    }
}

#[test]
fn meson_takes_subprojects() {
    if !tool("meson", "meson", "packages for Meson") || !tool("gcc", "gcc", "packages for Meson") {
        return;
    }
    let folder = packed("meson");
    let user = folder.path().join("user");
    let names = GRAPHS.map(|(name, _)| name);
    fs::create_dir_all(user.join("subprojects")).expect("the folder can be made");
    for name in names {
        fs::rename(folder.path().join(name), user.join("subprojects").join(name)).expect("it can be moved");
    }
    let dependencies =
        names.map(|name| format!("dependency('{name}', version: '>=0.1', fallback: ['{name}', '{name}_dep'])"));
    let text = format!(
        "project('user', 'c')\ntest('main', executable('main', 'main.c', dependencies: [{}]))\n",
        dependencies.join(", ")
    );
    write(&user.join("meson.build"), &text);
    write(&user.join("main.c"), &main_c());
    let meson = |words: &[&str], folder: &Path| {
        let mut command = Command::new("meson");
        good(command.current_dir(folder).args(words))
    };
    meson(&["setup", "build"], &user);
    let passed = |said: &str| said.lines().any(|line| line.split_whitespace().eq(["Ok:", "1"]));
    let said = meson(&["test", "-C", "build", "main"], &user);
    assert!(passed(&said), "{said}");
    // Its own example, too.
    let alone = user.join("subprojects/recall");
    meson(&["setup", "build", "-Dwerror=true", "-Dwarning_level=3"], &alone);
    let said = meson(&["test", "-C", "build"], &alone);
    assert!(passed(&said), "{said}");
}

#[test]
fn cargo_takes_several_in_one_program() {
    let folder = packed("cargo");
    let names = GRAPHS.map(|(name, _)| name);
    let dependencies: String = names.map(|name| format!("{name} = {{ path = \"../{name}\" }}\n")).concat();
    let manifest = "[package]\nname = \"user\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\n";
    write(&folder.path().join("user/Cargo.toml"), &format!("{manifest}{dependencies}"));
    let main = "use cartpole::Policy as _;\nuse pendulum::Policy as _;\nfn main() {\n    \
                println!(\"{}\", cartpole::Cartpole.decide(&[0.0, 0.0, 0.1, 0.1]).0);\n    \
                println!(\"{:?}\", pendulum::Pendulum.decide(&[1.0, 0.0, 1.0]));\n    \
                let mut memory = recall::Recall::INITIAL;\n    \
                println!(\"{}\", recall::Recall.infer(&[1.0, 0.0], &mut memory).len());\n}\n";
    write(&folder.path().join("user/src/main.rs"), main);
    let cargo = |words: &[&str], place: &str| {
        let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        command.current_dir(folder.path().join(place)).args(words).env("RUSTFLAGS", "--deny warnings");
        good(command.env("CARGO_TARGET_DIR", folder.path().join("target")))
    };
    let said = cargo(&["run", "--quiet", "--offline"], "user");
    assert_eq!(said, "1\n[-2.0]\n1\n");
    assert_eq!(cargo(&["run", "--quiet", "--offline", "--example", "decide"], "pendulum"), "[-0.0]\n");
    cargo(&["check", "--quiet", "--offline", "--examples"], "recall");
}

/// The part of Arduino's core that the sketch needs, on the chip itself.
const ARDUINO: &str = r#"
#include <avr/io.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

void setup();
void loop();

struct Port {
  void begin(long) { UCSR0B = _BV(TXEN0); }
  void put(char c) { while (!(UCSR0A & _BV(UDRE0))) {} UDR0 = c; }
  void print(const char *text) { while (*text) put(*text++); }
  void println(unsigned long number) { char text[12]; print(ultoa(number, text, 10)); print("\n"); }
  void println(int number) { char text[12]; print(itoa(number, text, 10)); print("\n"); }
  void println(uint16_t number) { println((unsigned long)number); }
  void println(double number, int places) { char text[24]; print(dtostrf(number, 1, places, text)); print("\n"); }
};
static Port Serial;
static inline void delay(unsigned long) { Serial.print("done\n"); for (;;) {} }
"#;

#[test]
fn arduino_sketches_run_on_an_uno() {
    let what = "packages for Arduino";
    if !tool("avr-g++", "gcc-avr, avr-libc", what) || !tool("qemu-system-avr", "qemu-system-misc", what) {
        return;
    }
    let folder = packed("arduino");
    write(&folder.path().join("Arduino.h"), ARDUINO);
    write(&folder.path().join("core.cpp"), "int main() { extern void setup(), loop(); setup(); for (;;) loop(); }\n");
    for (name, _) in GRAPHS {
        let library = folder.path().join(name);
        let properties = read(&library.join("library.properties"));
        let value = |key: &str| {
            let line = properties.lines().find_map(|line| line.strip_prefix(&format!("{key}=")));
            line.unwrap_or_else(|| panic!("{key}: {properties}")).to_owned()
        };
        for (key, wanted) in [("name", name), ("version", "0.1.0"), ("architectures", "*"), ("url", "")] {
            assert_eq!(value(key), wanted, "{name}");
        }
        assert_eq!((value("includes"), value("category")), (format!("{name}.h"), "Data Processing".to_owned()));
        // The flags of Arduino's own core for AVR.
        let flags = ["-mmcu=atmega328p", "-Os", "-w", "-ffunction-sections", "-fdata-sections"];
        let include = format!("-I{}", library.join("src").display());
        let compile = |program: &str, standard: &str, source: PathBuf, object: &str| {
            let mut command = Command::new(program);
            command.current_dir(folder.path()).args(flags).args([standard, &include, "-I.", "-c", "-o", object]);
            if source.extension().is_some_and(|extension| extension == "ino") {
                command.args(["-include", "Arduino.h", "-x", "c++"]);
            }
            good(command.arg(source));
        };
        compile("avr-gcc", "-std=gnu11", library.join(format!("src/{name}.c")), "policy.o");
        compile("avr-g++", "-std=gnu++11", library.join("examples/Decide/Decide.ino"), "sketch.o");
        compile("avr-g++", "-std=gnu++11", folder.path().join("core.cpp"), "core.o");
        let mut link = Command::new("avr-gcc");
        link.current_dir(folder.path()).args(flags).args(["-Wl,--gc-sections", "policy.o", "sketch.o", "core.o"]);
        good(link.args(["-lm", "-o", "sketch.elf"]));
        // QEMU 7.2 does not skip at the end of libgcc's `__usmulhisi3`, which multiplies 16 bits.
        if name == IN_COUNTS {
            continue;
        }
        // Nothing ends the machine: the shell does after its last line.
        let qemu = "qemu-system-avr -machine uno -display none -monitor none -serial file:said -bios sketch.elf & machine=$!\n\
                    for moment in $(seq 600); do grep -qs done said && break; sleep 0.1; done\nkill $machine; cat said; rm said";
        let said = good(Command::new("sh").current_dir(folder.path()).args(["-c", qemu]));
        let wanted = if name == "cartpole" { "action " } else { "torque " };
        assert!(said.starts_with("self-test, wrong: 0\n") && said.contains(wanted), "{name}: {said}");
    }
}

#[test]
fn examples_of_the_others_compile_and_their_manifests_have_the_fields() {
    let platformio = packed("platformio");
    let esp_idf = packed("esp-idf");
    let zephyr = packed("zephyr");
    let compiled = |folder: &Path, include: &str, source: &str, example: &str, words: &[&str]| {
        if !tool("gcc", "gcc", "examples of packages") {
            return;
        }
        let mut gcc = Command::new("gcc");
        gcc.current_dir(folder).args(["-std=gnu11", "-Wall", "-Wextra", "-Werror", "-o", "example"]);
        good(gcc.arg(format!("-I{include}")).args([source, example, "-lm"]).args(words));
        if words.is_empty() {
            assert!(good(&mut Command::new(folder.join("example"))).starts_with("self-test: 0 wrong\n"));
        }
    };
    for (name, _) in GRAPHS {
        let place = platformio.path().join(name);
        let manifest: serde_json::Value = serde_json::from_str(&read(&place.join("library.json"))).expect("JSON");
        assert_eq!((&manifest["name"], &manifest["version"]), (&name.into(), &"0.1.0".into()));
        assert_eq!((&manifest["platforms"], &manifest["license"]), (&"*".into(), &"MIT OR Apache-2.0".into()));
        assert!(place.join(manifest["examples"][0]["base"].as_str().expect("a path")).join("main.c").is_file());
        compiled(&place, "include", &format!("src/{name}.c"), "examples/decide/main.c", &[]);

        let place = esp_idf.path().join(name);
        let manifest = read(&place.join("idf_component.yml"));
        assert!(manifest.contains("version: \"0.1.0\"\n") && manifest.contains("  idf: \">=5.0\"\n"), "{manifest}");
        let register = read(&place.join("CMakeLists.txt"));
        assert_eq!(register, format!("idf_component_register(SRCS \"{name}.c\" INCLUDE_DIRS \"include\")\n"));
        compiled(
            &place,
            "include",
            &format!("{name}.c"),
            "examples/decide/main/main.c",
            &["-Dapp_main=main", "-Wno-main"],
        );

        let place = zephyr.path().join(name);
        assert!(read(&place.join("README.md")).contains("no build with Zephyr was tested"));
        let module = read(&place.join("zephyr/module.yml"));
        for path in ["zephyr/Kconfig", "zephyr/CMakeLists.txt", "samples/decide/prj.conf"] {
            assert!(place.join(path).is_file(), "{module}");
        }
        compiled(&place, "include", &format!("src/{name}.c"), "samples/decide/src/main.c", &[]);
    }
    // Their own packer, where somebody installed it.
    if !exists("compote") {
        return skip("the packer of ESP-IDF: not installed (pip install idf-component-manager)");
    }
    let mut compote = Command::new("compote");
    compote.current_dir(esp_idf.path().join("recall"));
    good(compote.args(["component", "pack", "--name", "recall"]));
}

#[test]
fn all_of_a_package_is_written_or_nothing() {
    let folder = TempDir::new().expect("a temporary folder");
    let graph = top().join("generated/cartpole/graph.json");
    let package = |words: &[&str]| {
        let mut command = codegen();
        let output = command.current_dir(folder.path()).arg("package").arg(&graph).args(words).assert().code(2);
        String::from_utf8(output.get_output().stderr.clone()).expect("text")
    };
    // A file where a folder has to be.
    write(&folder.path().join("here/src"), "mine");
    let said = package(&["--for", "cmake", "-o", "here"]);
    assert!(said.contains("here/src"), "{said}");
    let left: Vec<_> = fs::read_dir(folder.path().join("here")).expect("a folder").flatten().collect();
    assert!(left.len() == 1 && read(&folder.path().join("here/src")) == "mine", "{left:?}");
    // Bad words.
    let said = package(&["--for", "cmake", "-o", "there", "--package-version", "1.0"]);
    assert!(said.contains("three numbers"), "{said}");
    let said = package(&["--for", "cmake", "-o", "there", "--license", "MIT"]);
    assert!(said.contains("--license-file"), "{said}");
    let said = package(&["--for", "cmake", "-o", "there", "--license", "MIT", "--license-file", "absent"]);
    assert!(said.contains("absent") && said.contains("accepted: the text of the licence"), "{said}");
    let said = package(&["--for", "arduino", "-o", "there", "--scalar", "f64"]);
    assert!(said.contains("accepted: --scalar f32"), "{said}");
    let said = package(&["--for", "cmake", "-o", "there", "--author", "two\nlines"]);
    assert!(said.contains("one line"), "{said}");
    assert!(!folder.path().join("there").exists());
}

#[test]
fn a_licence_of_ones_own_and_a_proof() {
    let folder = TempDir::new().expect("a temporary folder");
    write(&folder.path().join("TERMS"), "All mine.\n");
    let mut command = codegen();
    command.current_dir(folder.path()).args(["package", "--for", "meson", "-o", "out", "--prefix", "cart"]);
    command.args(["--license", "LicenseRef-Mine", "--license-file", "TERMS", "--package-version", "2.3.4"]);
    let output = command.arg(top().join("generated/cartpole/graph.json")).assert().success();
    let said = String::from_utf8(output.get_output().stdout.clone()).expect("text");
    assert!(said.contains("= interpreter on 10000 states"), "{said}");
    let manifest = read(&folder.path().join("out/meson.build"));
    assert!(manifest.contains("version: '2.3.4'") && manifest.contains("license: 'LicenseRef-Mine'"), "{manifest}");
    assert_eq!(read(&folder.path().join("out/LICENSE")), "All mine.\n");
    assert!(!folder.path().join("out/LICENSE-MIT").exists());
}
