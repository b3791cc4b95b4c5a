//! The files of each ecosystem.

use super::details::Ecosystem;
use super::facts::Facts;
use crate::emit::Code;
use Ecosystem::*;
use askama::Template;
use tpg_runtime::standalone;

/// The build file of ESP-IDF's example, the same for every policy.
const ESP_IDF_MAIN: &str = include_str!("../../templates/package/esp_idf_main.cmake");

/// Renders a template about `it`, the facts.
macro_rules! text {
    ($facts:expr, $path:tt) => {{
        #[derive(Template)]
        #[template(path = $path, escape = "none")]
        struct It<'a> {
            it: &'a Facts<'a>,
        }
        ended(It { it: $facts }.render())
    }};
}

/// A program in C that asks the policy: `esp` has another entry point than C's.
#[derive(Template)]
#[template(path = "package/example.c", escape = "none")]
struct Example<'a> {
    it: &'a Facts<'a>,
    entry: &'a str,
    returns: bool,
}

/// The README.
#[derive(Template)]
#[template(path = "package/README.md", escape = "none")]
struct Readme<'a> {
    it: &'a Facts<'a>,
    ecosystem: Ecosystem,
}

fn ended(text: askama::Result<String>) -> String {
    // Formatting into a string fails only where a value's own formatting does: none here does.
    let mut text = text.unwrap_or_default();
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text
}

/// Every file of a package.
pub(super) fn files(facts: &Facts<'_>, ecosystem: Ecosystem, code: &Code<'_>) -> Vec<(String, String)> {
    let name = facts.name;
    let main = || ended(Example { it: facts, entry: "int main(void)", returns: true }.render());
    let mut files: Vec<(String, String)> = facts.details.license.files.clone();
    files.push(("README.md".to_owned(), ended(Readme { it: facts, ecosystem }.render())));
    let (mut add, mut sources) = (Vec::new(), ("include", "src"));
    match ecosystem {
        Arduino => {
            sources = ("src", "src");
            add.push(("library.properties".to_owned(), text!(facts, "package/library.properties")));
            add.push(("keywords.txt".to_owned(), text!(facts, "package/keywords.txt")));
            add.push(("examples/Decide/Decide.ino".to_owned(), text!(facts, "package/Decide.ino")));
        }
        Platformio => {
            add.push(("library.json".to_owned(), library_json(facts)));
            add.push(("examples/decide/main.c".to_owned(), main()));
        }
        EspIdf => {
            sources = ("include", "");
            let entry = Example { it: facts, entry: "void app_main(void)", returns: false };
            add.push(("idf_component.yml".to_owned(), text!(facts, "package/idf_component.yml")));
            add.push(("CMakeLists.txt".to_owned(), text!(facts, "package/esp_idf.cmake")));
            add.push(("examples/decide/CMakeLists.txt".to_owned(), text!(facts, "package/esp_idf_project.cmake")));
            add.push(("examples/decide/main/CMakeLists.txt".to_owned(), ESP_IDF_MAIN.to_owned()));
            add.push(("examples/decide/main/idf_component.yml".to_owned(), text!(facts, "package/esp_idf_main.yml")));
            add.push(("examples/decide/main/main.c".to_owned(), ended(entry.render())));
        }
        Zephyr => {
            add.push(("zephyr/module.yml".to_owned(), text!(facts, "package/zephyr_module.yml")));
            add.push(("zephyr/CMakeLists.txt".to_owned(), text!(facts, "package/zephyr.cmake")));
            add.push(("zephyr/Kconfig".to_owned(), text!(facts, "package/zephyr.kconfig")));
            add.push(("samples/decide/CMakeLists.txt".to_owned(), text!(facts, "package/zephyr_sample.cmake")));
            add.push(("samples/decide/prj.conf".to_owned(), text!(facts, "package/zephyr_prj.conf")));
            add.push(("samples/decide/sample.yaml".to_owned(), text!(facts, "package/zephyr_sample.yaml")));
            add.push(("samples/decide/src/main.c".to_owned(), main()));
        }
        Cmake => {
            add.push(("CMakeLists.txt".to_owned(), text!(facts, "package/cmake.cmake")));
            add.push((format!("cmake/{name}-config.cmake.in"), text!(facts, "package/cmake_config.cmake")));
            add.push(("examples/decide.c".to_owned(), main()));
        }
        Meson => {
            add.push(("meson.build".to_owned(), text!(facts, "package/meson.build")));
            add.push(("examples/decide.c".to_owned(), main()));
        }
        Cargo => {
            add.push(("Cargo.toml".to_owned(), text!(facts, "package/crate.toml")));
            add.push(("src/lib.rs".to_owned(), text!(facts, "package/lib.rs")));
            add.push(("examples/decide.rs".to_owned(), text!(facts, "package/decide.rs")));
            add.push(("runtime/Cargo.toml".to_owned(), text!(facts, "package/crate_runtime.toml")));
            let runtime = standalone::FILES
                .into_iter()
                .map(|(path, text)| (format!("runtime/src/{path}"), text.replace("extern crate std;\n", "")));
            add.extend(runtime);
        }
    }
    for file in &code.files {
        let folder = if file.name.ends_with(".h") { sources.0 } else { sources.1 };
        let path = if folder.is_empty() { file.name.clone() } else { format!("{folder}/{}", file.name) };
        add.push((path, file.text.clone()));
    }
    files.extend(add);
    files
}

/// PlatformIO's manifest.
fn library_json(facts: &Facts<'_>) -> String {
    let details = facts.details;
    let mut manifest = serde_json::json!({
        "name": facts.name,
        "version": details.version,
        "description": facts.title,
        "keywords": ["control", "policy", "reinforcement learning"],
        "authors": [{ "name": details.author }],
        "license": details.license.spdx,
        "frameworks": "*",
        "platforms": "*",
        "headers": format!("{}.h", facts.name),
        "examples": [{ "name": "decide", "base": "examples/decide", "files": ["main.c"] }],
    });
    if let Some(url) = &details.url {
        manifest["homepage"] = url.as_str().into();
    }
    ended(Ok(format!("{manifest:#}")))
}
