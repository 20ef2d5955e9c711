//! Inputs out of inputs: the same for the same seed on every machine.

/// A reproducible stream of random numbers (xorshift64*, Vigna 2016).
pub struct Random(u64);

impl Random {
    /// A stream of its own for each seed.
    pub fn new(seed: u64) -> Self {
        // One step of splitmix64, so that neighbouring seeds have nothing in common.
        let mut z = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        Self((z ^ (z >> 27)) | 1)
    }

    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A number below `bound`; 0 if that is 0.
    pub fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.bits()) * bound as u128) >> 64) as usize
    }
}

/// Words that readers of numbers stumble over.
const NUMBERS: [&str; 20] = [
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "7",
    "255",
    "65536",
    "2147483647",
    "4294967295",
    "4294967296",
    "18446744073709551615",
    "-9223372036854775808",
    "1e308",
    "1e-320",
    "NaN",
    "inf",
    "0.1",
    "9007199254740993",
];

/// Bytes that mean something to some format.
const LETTERS: &[u8] = b"0123456789-+.eE#\\\"'\n\r\t []{}()<>,/:;=%\xff\0";

/// An input made of those in `pool`, of which there is at least one, and of `words`.
pub fn mutant(random: &mut Random, pool: &[Vec<u8>], words: &[Vec<u8>], longest: usize) -> Vec<u8> {
    let mut input = pool[random.below(pool.len())].clone();
    let rounds = 1 << random.below(4);
    for _ in 0..rounds {
        once(random, &mut input, pool, words);
    }
    input.truncate(longest);
    input
}

fn once(random: &mut Random, input: &mut Vec<u8>, pool: &[Vec<u8>], words: &[Vec<u8>]) {
    let length = input.len();
    let at = random.below(length + 1);
    let part = |random: &mut Random| {
        let longest = if random.below(4) == 0 { length } else { 16 };
        at..(at + random.below(longest + 1)).min(length)
    };
    match random.below(14) {
        0 if at < length => input[at] ^= 1 << random.below(8),
        1 if at < length => input[at] = LETTERS[random.below(LETTERS.len())],
        2 if at < length => input[at] = random.bits() as u8,
        3 => input.insert(at, LETTERS[random.below(LETTERS.len())]),
        4 => drop(input.drain(part(random))),
        5 => {
            // A part again, here or elsewhere.
            let copy = input[part(random)].to_vec();
            let to = random.below(length + 1);
            input.splice(to..to, copy);
        }
        6 => {
            let other = &pool[random.below(pool.len())];
            let from = random.below(other.len() + 1);
            input.truncate(at);
            input.extend_from_slice(&other[from..]);
        }
        7 | 8 if !words.is_empty() => {
            let word = words[random.below(words.len())].clone();
            input.splice(at..at, word);
        }
        9 => line(random, input, pool),
        10 | 11 => number(random, input),
        12 => token(random, input, words),
        _ => {
            let byte = input.get(at).copied().unwrap_or(b'0');
            let times = random.below(40);
            input.splice(at..at, std::iter::repeat_n(byte, times));
        }
    }
}

fn lines(input: &[u8]) -> Vec<&[u8]> {
    input.split_inclusive(|&byte| byte == b'\n').collect()
}

/// A line is left out, said twice, exchanged with another, or comes from another input.
fn line(random: &mut Random, input: &mut Vec<u8>, pool: &[Vec<u8>]) {
    let mut all = lines(input);
    if all.is_empty() {
        return;
    }
    let (i, j) = (random.below(all.len()), random.below(all.len()));
    match random.below(4) {
        0 => drop(all.remove(i)),
        1 => all.insert(j, all[i]),
        2 => all.swap(i, j),
        _ => {
            let other = lines(&pool[random.below(pool.len())]);
            if let Some(line) = other.get(random.below(other.len())) {
                all.insert(i, line);
            }
        }
    }
    *input = all.concat();
}

/// The ranges of bytes that `is_part` accepts.
fn ranges(input: &[u8], is_part: impl Fn(u8) -> bool) -> Vec<std::ops::Range<usize>> {
    let mut all = Vec::new();
    let mut start = None;
    for (i, byte) in input.iter().chain(&[0]).enumerate() {
        match (is_part(*byte), start) {
            (true, None) => start = Some(i),
            (false, Some(first)) => {
                all.push(first..i);
                start = None;
            }
            _ => {}
        }
    }
    all
}

/// A number becomes another one, often a neighbour or another number of the input.
fn number(random: &mut Random, input: &mut Vec<u8>) {
    let numbers = ranges(input, |byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'-'));
    if numbers.is_empty() {
        return;
    }
    let range = numbers[random.below(numbers.len())].clone();
    let old = String::from_utf8_lossy(&input[range.clone()]).parse::<f64>().unwrap_or(0.0);
    let new = match random.below(6) {
        0 => NUMBERS[random.below(NUMBERS.len())].to_owned(),
        1 => (old + 1.0).to_string(),
        2 => (old - 1.0).to_string(),
        3 => (-old).to_string(),
        4 => f64::from_bits(old.to_bits().wrapping_add(1)).to_string(),
        _ => String::from_utf8_lossy(&input[numbers[random.below(numbers.len())].clone()]).into_owned(),
    };
    input.splice(range, new.into_bytes());
}

/// A word becomes another one: of the dictionary or of the input.
fn token(random: &mut Random, input: &mut Vec<u8>, words: &[Vec<u8>]) {
    let tokens = ranges(input, |byte| byte.is_ascii_alphanumeric() || byte == b'_');
    if tokens.is_empty() {
        return;
    }
    let range = tokens[random.below(tokens.len())].clone();
    let new = if words.is_empty() || random.below(2) == 0 {
        input[tokens[random.below(tokens.len())].clone()].to_vec()
    } else {
        words[random.below(words.len())].clone()
    };
    input.splice(range, new);
}
