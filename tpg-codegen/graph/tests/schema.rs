//! The committed schema matches the code and describes what the tool writes.

/// With `TPG_UPDATE=1` the file is rewritten.
#[test]
fn the_committed_schema_is_fresh() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/graph.schema.json");
    let fresh = tpg_graph::schema();
    if std::env::var_os("TPG_UPDATE").is_some_and(|value| value == "1") {
        std::fs::write(path, &fresh).expect("the schema can be written");
    }
    let committed = std::fs::read_to_string(path).expect("the schema is committed");
    assert!(committed == fresh, "graph.schema.json is stale: TPG_UPDATE=1 cargo test -p tpg-graph schema:: writes it");
}
