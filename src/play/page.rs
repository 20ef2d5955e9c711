//! A file put into the page, so that it begins with it.

/// Where the page has room for a file.
const ROOM: &str = "<script type=\"text/plain\" id=\"scene\" data-name=\"\"></script>";

/// The page of the playground with a file inside; `None` if this is no such page, or it holds a file already.
///
/// Cost: linear.
#[must_use]
pub fn page_with(page: &str, name: &str, bytes: &[u8]) -> Option<String> {
    let (before, after) = page.split_once(ROOM)?;
    let name = crate::figure::escaped(name).replace('"', "&quot;");
    let data = base64(bytes);
    Some(format!("{before}<script type=\"text/plain\" id=\"scene\" data-name=\"{name}\">{data}</script>{after}"))
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let data = super::link::base64(bytes, LETTERS);
    let padding = "=".repeat(data.len().next_multiple_of(4) - data.len());
    data + &padding
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_put_where_the_page_has_room_and_nowhere_else() {
        let page = format!("<body>{ROOM}</body>");
        let with = page_with(&page, "a \"b\"<c>.obj", b"v 0 0\n").unwrap();
        assert_eq!(
            with,
            "<body><script type=\"text/plain\" id=\"scene\" data-name=\"a &quot;b&quot;&lt;c&gt;.obj\">diAwIDAK</script></body>"
        );
        assert_eq!(page_with(&with, "x", b""), None);
        let ends = [&b""[..], b"f", b"fo", b"foo", b"foob", b"fooba", b"foobar"].map(base64);
        assert_eq!(ends, ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"], "RFC 4648, section 10");
    }
}
