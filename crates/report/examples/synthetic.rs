//! Draws the report of a synthetic folder, to look at: `cargo run -p stratiform-report --example synthetic DIR`.

#[path = "../tests/folder/mod.rs"]
mod folder;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let dir = std::env::args_os().nth(1).ok_or("name a folder")?;
    let dir = std::path::Path::new(&dir);
    folder::write(dir);
    stratiform_report::build(dir)?;
    Ok(())
}
