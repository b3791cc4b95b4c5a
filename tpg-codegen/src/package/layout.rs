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
    let mut added: Vec<(String, String)> = Vec::new();
    let mut add = |path: &str, text: String| added.push((path.to_owned(), text));
    let mut sources = ("include", "src");
    match ecosystem {
        Arduino => {
            sources = ("src", "src");
            add("library.properties", text!(facts, "package/library.properties"));
            add("keywords.txt", text!(facts, "package/keywords.txt"));
            add("examples/Decide/Decide.ino", text!(facts, "package/Decide.ino"));
        }
        Platformio => {
            add("library.json", library_json(facts));
            add("examples/decide/main.c", main());
        }
        EspIdf => {
            sources = ("include", "");
            let entry = Example { it: facts, entry: "void app_main(void)", returns: false };
            add("idf_component.yml", text!(facts, "package/idf_component.yml"));
            add("CMakeLists.txt", text!(facts, "package/esp_idf.cmake"));
            add("examples/decide/CMakeLists.txt", text!(facts, "package/esp_idf_project.cmake"));
            add("examples/decide/main/CMakeLists.txt", ESP_IDF_MAIN.to_owned());
            add("examples/decide/main/idf_component.yml", text!(facts, "package/esp_idf_main.yml"));
            add("examples/decide/main/main.c", ended(entry.render()));
        }
        Zephyr => {
            add("zephyr/module.yml", text!(facts, "package/zephyr_module.yml"));
            add("zephyr/CMakeLists.txt", text!(facts, "package/zephyr.cmake"));
            add("zephyr/Kconfig", text!(facts, "package/zephyr.kconfig"));
            add("samples/decide/CMakeLists.txt", text!(facts, "package/zephyr_sample.cmake"));
            add("samples/decide/prj.conf", text!(facts, "package/zephyr_prj.conf"));
            add("samples/decide/sample.yaml", text!(facts, "package/zephyr_sample.yaml"));
            add("samples/decide/src/main.c", main());
        }
        Cmake => {
            add("CMakeLists.txt", text!(facts, "package/cmake.cmake"));
            add(&format!("cmake/{name}-config.cmake.in"), text!(facts, "package/cmake_config.cmake"));
            add("examples/decide.c", main());
        }
        Meson => {
            add("meson.build", text!(facts, "package/meson.build"));
            add("examples/decide.c", main());
        }
        Cargo => {
            add("Cargo.toml", text!(facts, "package/crate.toml"));
            add("src/lib.rs", text!(facts, "package/lib.rs"));
            add("examples/decide.rs", text!(facts, "package/decide.rs"));
            add("runtime/Cargo.toml", text!(facts, "package/crate_runtime.toml"));
            for (path, text) in standalone::FILES {
                add(&format!("runtime/src/{path}"), text.replace("extern crate std;\n", ""));
            }
        }
    }
    for file in &code.files {
        let folder = if file.name.ends_with(".h") { sources.0 } else { sources.1 };
        let path = if folder.is_empty() { file.name.clone() } else { format!("{folder}/{}", file.name) };
        add(&path, file.text.clone());
    }
    files.extend(added);
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
