//! The page in a browser: see `browser.mjs`.

mod support;

use std::process::Command;
use support::page;
use tpg_testing::library::top;

#[test]
fn the_arm_reaches_follows_the_hand_and_reaches_again() {
    let Some(folder) = page("the page in a browser", &["node", "chromium"]) else { return };
    let web = top().join("web");
    assert!(web.join("node_modules/playwright-core").is_dir(), "cargo xtask web installs playwright-core");
    let out = folder.with_file_name("web-pictures");
    let mut browser = Command::new("node");
    browser.arg(web.join("tests/browser.mjs")).arg(&folder).arg("/usr/bin/chromium").arg(&out);
    let output = browser.output().expect("node starts");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    println!("{said}pictures: {}", out.display());
}
