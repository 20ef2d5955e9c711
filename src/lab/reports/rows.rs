//! Tables with commas, for spreadsheets.

/// A table with a head, as RFC 4180 has it.
pub(crate) fn rows(head: &[&str], rows: Vec<Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing into memory cannot fail, and every row is as long as the head.
    let _ = writer.write_record(head);
    for row in rows {
        let _ = writer.write_record(row.iter().map(|cell| harmless(cell)));
    }
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// The cell, with an apostrophe where a spreadsheet would see a formula. Numbers stay numbers.
fn harmless(cell: &str) -> String {
    let bare = cell.trim_start_matches(|c: char| c.is_whitespace() && !"\t\r\n".contains(c));
    let formula = bare.starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠', '\t', '\r', '\n']);
    if formula && cell.parse::<f64>().is_err() { format!("'{cell}") } else { cell.to_owned() }
}
