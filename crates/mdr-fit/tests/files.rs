//! Curves in files, as instruments and spreadsheets write them: one curve in many notations is one curve.
#![cfg(feature = "toml")]
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_fit::{CurveText, Problem};

/// Force against depth in nm and nN: a sphere of 10 µm, approach and retract.
const ROWS: [[&str; 3]; 6] = [
    ["-50.5", "0.25", "approach"],
    ["500", "1202.5", "approach"],
    ["2000.0", "22186.5", "approach"],
    ["1000", "6718.5", "retract"],
    ["-1.5e2", "-2.25e3", "retract"],
    ["-900", "0.5", "retract"],
];

/// Rows between separators, with another decimal mark and other names of the legs.
fn rows(separator: &str, mark: &str, legs: Option<[&str; 2]>) -> String {
    let row = |[x, y, leg]: [&str; 3]| {
        let [x, y] = [x, y].map(|number| number.replace('.', mark));
        let leg = legs.map(|names| names[usize::from(leg == "retract")]);
        [Some(x.as_str()), Some(y.as_str()), leg].into_iter().flatten().collect::<Vec<_>>().join(separator) + "\n"
    };
    ROWS.map(row).concat()
}

fn open(bytes: &[u8], data: &str) -> Result<Problem, String> {
    let fit = format!(
        "profile = {{ kind = \"paraboloid\", radius = \"1e-5\" }}\nfit = {{ free = [\"e_star\", \"work_of_adhesion\"] }}\n\
         [data]\nfile = \"curve.txt\"\nobservation = \"F(d)\"\n{data}\n"
    );
    Problem::from_toml(&fit, "fit.toml", &|_: &str| Ok(bytes.to_vec())).map_err(|error| error.to_string())
}

/// Rows that are not in a file have no columns: a name in the place of a number is refused, and not passed over.
#[test]
fn names_of_columns_beside_rows_are_refused() {
    for (given, key) in
        [("sigma = { y = \"nan(1e-9)\" }", "data.sigma"), ("columns = { x = \"depth\" }", "data.columns")]
    {
        let fit = format!(
            "profile = {{ kind = \"paraboloid\", radius = \"1e-5\" }}\nfit = {{ free = [\"e_star\", \"work_of_adhesion\"] }}\n\
             [data]\nrows = [[0, 0], [1e-9, 2e-9], [2e-9, 5e-9]]\nobservation = \"F(d)\"\n{given}\n"
        );
        let why = Problem::from_toml(&fit, "fit.toml", &|_: &str| Ok(Vec::new())).unwrap_err().to_string();
        assert!(why.contains(key) && why.contains("give numbers"), "{why}");
    }
}

/// The rows and how they were read.
fn read(bytes: &[u8], data: &str) -> (Vec<[f64; 2]>, CurveText) {
    let problem = open(bytes, data).unwrap_or_else(|why| panic!("{why}\n{}", String::from_utf8_lossy(bytes)));
    (problem.data().collect(), problem.read_from().unwrap().clone())
}

fn expected() -> Vec<[f64; 2]> {
    let number = |text: &str| text.parse::<f64>().unwrap();
    // Both are the double nearest to the decimal.
    ROWS.map(|[x, y, _]| [format!("{:e}e-9", number(x)), format!("{:e}e-9", number(y))])
        .map(|pair| pair.map(|text| nearest(&text)))
        .to_vec()
}

/// A number with two exponents.
fn nearest(text: &str) -> f64 {
    let (head, tail) = text.rsplit_once('e').unwrap();
    let (mantissa, exponent) = head.split_once('e').unwrap();
    format!("{mantissa}e{}", exponent.parse::<i32>().unwrap() + tail.parse::<i32>().unwrap()).parse().unwrap()
}

/// What of the layout a case says: separator, decimal mark, first line.
type Layout = (&'static str, &'static str, usize);

#[test]
fn one_curve_in_many_notations() {
    let plain = |header: &str, separator: &str, mark: &str| format!("{header}\n{}", rows(separator, mark, None));
    let jpk = {
        let all = rows(" ", ".", None);
        let (down, up) = all.split_at(all.find("1000").unwrap());
        let about = "# columns: height vDeflection\n# fancyNames: \"Height (measured)\" \"Vertical deflection\"\n# units: nm nN\n";
        format!("# springConstant: 0.04\n# segment: extend\n{about}{down}\n# segment: retract\n{about}{up}")
    };
    let cases: Vec<(String, &str, Layout)> = vec![
        (plain("d,F\nnm,nN", ",", "."), "", ("comma", "point", 3)),
        (plain("d [nm],F [nN]", ",", "."), "", ("comma", "point", 2)),
        (plain("d (nm);F (nN)", ";", ","), "", ("semicolon", "comma", 2)),
        (plain("d / nm\tF / nN", "\t", ","), "", ("tab", "comma", 2)),
        (plain("d, nm\tF, nN", "\t", "."), "", ("tab", "point", 2)),
        (plain("d [nm]  F [nN]", "   ", "."), "", ("blanks", "point", 2)),
        (plain("d/nm F/nN", " ", ","), "", ("blanks", "comma", 2)),
        (plain("% d [nm] F [nN]", "  ", "."), "", ("blanks", "point", 2)),
        (plain("# d [nm]\tF [nN]", "\t", "."), "", ("tab", "point", 2)),
        (plain("\"Height (measured)\" Force\nnm nN", " ", "."), "", ("blanks", "point", 3)),
        (
            plain("Instrument: AFM 7\nSize, 512, 512\nk = 0.04 N/m\n\nd [nm],F [nN]", ",", "."),
            "",
            ("comma", "point", 6),
        ),
        (plain("Date;2020-01-02\nGain;3\nd;F\nnm;nN", ";", ","), "", ("semicolon", "comma", 5)),
        (plain("Date;2020-01-02\nd;F", ";", ","), "units = [\"nm\", \"nN\"]", ("semicolon", "comma", 3)),
        (rows("\t", ".", None), "units = [\"nm\", \"nN\"]", ("tab", "point", 1)),
        (plain("nm,nN", ",", "."), "", ("comma", "point", 2)),
        (plain("F [nN],t [s],d [nm]", ",", ".").replace("\n", ",\n"), "", ("comma", "point", 2)),
        (jpk, "", ("blanks", "point", 6)),
    ];
    for (text, data, layout) in cases {
        let turned = text.starts_with("F [nN],t");
        let text = if turned { turn(&text) } else { text };
        let (found, how) = read(text.as_bytes(), data);
        assert_eq!(found, expected(), "{text}");
        assert_eq!((how.separator, how.decimal_mark, how.first_line), layout, "{text}");
        // A file of Windows, and one of an old Macintosh.
        for end in ["\r\n", "\r"] {
            let other = text.replace('\n', end);
            assert_eq!(read(other.as_bytes(), data), (found.clone(), how.clone()), "{other:?}");
        }
    }
}

/// Rows `d,F,` as rows `F,0.5,d`.
fn turn(text: &str) -> String {
    let (header, rows) = text.split_once('\n').unwrap();
    let row = |line: &str| {
        let (x, y) = line.trim_end_matches(',').split_once(',').unwrap();
        format!("{y},0.5,{x}\n")
    };
    format!("{}\n{}", header.trim_end_matches(','), rows.lines().map(row).collect::<String>())
}

/// Dates and times beside the numbers, and the first line that some spreadsheets write.
#[test]
fn other_columns_may_hold_anything() {
    let timed = |separator: &str, mark: &str| {
        let row = |line: &str| format!("2020-01-02 12:00:05{separator}{line}{separator}ok\n");
        rows(separator, mark, None).lines().map(row).collect::<String>()
    };
    for (text, number) in [
        (format!("time,d [nm],F [nN],state\n{}", timed(",", ".")), 2),
        (format!("sep=;\ntime;d [nm];F [nN];state\n{}", timed(";", ",")), 2),
        (format!("time\td\tF\n\tnm\tnN\n{}", timed("\t", ",")), 2),
        (format!("d [nm] F [nN] day clock\n{}", rows(" ", ",", None).replace('\n', " 2020-01-02 12:00:05\n")), 1),
    ] {
        let (found, how) = read(text.as_bytes(), "");
        assert_eq!((found, how.x.number, how.y.number), (expected(), number, number + 1), "{text}");
    }
}

#[test]
fn every_encoding_is_one_text() {
    let text = format!("Größe\tµ\nd [µm]\tF [nN]\n{}", rows("\t", ",", None));
    let wide = |order: fn(u16) -> [u8; 2], mark: [u8; 2]| {
        mark.into_iter().chain(text.encode_utf16().flat_map(order)).collect::<Vec<u8>>()
    };
    let latin: Vec<u8> = text.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap()).collect();
    let marked: Vec<u8> = b"\xef\xbb\xbf".iter().chain(text.as_bytes()).copied().collect();
    let cases = [
        (text.as_bytes().to_vec(), "utf-8"),
        (marked, "utf-8"),
        (wide(u16::to_le_bytes, [0xff, 0xfe]), "utf-16le"),
        (wide(u16::to_be_bytes, [0xfe, 0xff]), "utf-16be"),
        (latin, "latin-1"),
    ];
    let (plain, _) = read(text.as_bytes(), "");
    assert_eq!(plain[1][0], 500e-6);
    for (bytes, encoding) in cases {
        let (found, how) = read(&bytes, "");
        assert_eq!((&found, how.encoding), (&plain, encoding));
        assert_eq!(how.x.unit.as_deref(), Some("µm"));
    }
    // Half a character, an odd byte, and binary.
    let odd = [0xff, 0xfe, b'1', 0, b'\n', 0, b'2'];
    let half = [0xfe, 0xff, 0, b'\n', 0xd8, 0x00, 0, b'2'];
    for (bytes, why) in [
        (&odd[..], "line 2 ends in half"),
        (&half, "line 2 has half a character"),
        (b"1 2\n\x00\x01", "line 2 has the character 0x00"),
    ] {
        let error = open(bytes, "").unwrap_err();
        assert!(error.contains(why), "{error}");
    }
}

#[test]
fn legs_have_the_names_of_instruments() {
    let legs = |text: &str, data: &str| {
        let debug = format!("{:?}", open(text.as_bytes(), data).unwrap());
        debug.matches("leg: Approach").count()
    };
    for names in [["Extend", "Retract"], ["trace", "retrace"], ["approach", "withdraw"], ["load", "UNLOAD"]] {
        let text = format!("d [nm];F [nN];segment\n{}", rows(";", ",", Some(names)));
        assert_eq!(legs(&text, "columns = { leg = \"segment\" }"), 3, "{names:?}");
    }
    let text = format!("d [nm];F [nN];segment\n{}", rows(";", ",", Some(["pause", "retract"])));
    let error = open(text.as_bytes(), "columns = { leg = \"segment\" }").unwrap_err();
    assert!(error.contains("line 2: a leg is") && error.contains("`pause`"), "{error}");
}

#[test]
fn columns_by_name_number_and_unit() {
    let text = "Ramp [V];Ramp [nm];Defl [V];Defl [nN];Height [nm]\n1;2;3;4;5\n2;3;4;6;8\n3;4;5;9;9\n";
    let take = |columns: &str| {
        let problem = open(text.as_bytes(), &format!("columns = {columns}"))?;
        let how = problem.read_from().unwrap();
        Ok::<_, String>([how.x.number, how.y.number])
    };
    for (columns, places) in [
        ("{ x = \"Ramp [nm]\", y = \"Defl [nN]\" }", [2, 4]),
        ("{ x = 2, y = 4 }", [2, 4]),
        ("{ x = \"5\", y = \"[nN]\" }", [5, 4]),
        ("{ x = \"Height\", y = \"Defl [nN]\" }", [5, 4]),
        ("{ x = \"Height [nm]\" }", [5, 4]),
    ] {
        assert_eq!(take(columns), Ok(places), "{columns}");
    }
    for (columns, parts) in [
        ("{}", &["`m` is ambiguous", "2 (`Ramp [nm]`), 5 (`Height [nm]`)"][..]),
        ("{ x = \"nm\", y = \"nN\" }", &["`nm` is ambiguous", "choose by name or by number"]),
        ("{ x = \"Ramp\", y = \"nN\" }", &["`Ramp` is ambiguous", "1 (`Ramp [V]`), 2 (`Ramp [nm]`)"]),
        ("{ x = \"Defl [V]\", y = \"nN\" }", &["`V` is no unit of length"]),
        ("{ x = \"Heigth\", y = \"nN\" }", &["did you mean `Height`"]),
        ("{ x = 9, y = \"nN\" }", &["no units"]),
    ] {
        let error = take(columns).unwrap_err();
        assert!(parts.iter().all(|part| error.contains(part)), "{columns}: {error}");
    }
    // Two columns in metres, both called Ramp; and the first two where there are more.
    let twice = "Ramp,F,Ramp\nnm,nN,nm\n1,2,3\n2,3,4\n3,5,6\n";
    let error = open(twice.as_bytes(), "").unwrap_err();
    assert!(error.contains("`Ramp` is ambiguous"), "{error}");
    assert!(open(twice.as_bytes(), "columns = { x = 3, y = \"F\" }").is_ok());
    let problem = open(format!("d [nm],F [nN],z [nm]\n{}", rows(",", ".", Some(["1", "2"]))).as_bytes(), "").unwrap();
    let fit = problem.fit().unwrap();
    assert!(fit.warnings.iter().any(|warning| warning.contains("others in the same units, such as `z [nm]`")));
    assert_eq!(fit.read.map(|how| how.y.number), Some(2));
}

/// What is ambiguous or broken is refused with the number of its line, and never read as something else.
#[test]
fn nothing_is_guessed() {
    let wide = format!("d [nm],F [nN]\n1,2\n{},3\n", "7x".repeat(500));
    let bell = "d [nm],F [nN]\n1,2\n\u{1b}[31m,3\n";
    let turned = "d [nm],F [nN]\n1,2\n\u{202e}1,3\n";
    for (text, parts) in [
        ("d,F\n1,2\n3,4\n5,6\n", &["no units"][..]),
        ("d_nm,F_nN\n1,2\n3,4\n5,6\n", &["no units"]),
        ("d [V],F [nN]\n1,2\n3,4\n5,6\n", &["`V` is no unit of length"]),
        ("d [nm],F [nN]\n1,5,2,5\n3,4,1,0\n", &["line 2: 4 columns, and the header has 2", "semicolons"]),
        ("nm,nN\n0,5, 1,2\n0,6, 1,7\n", &["commas", "decimal marks or separators"]),
        ("d [nm];F [nN]\n1,5;2\n1.6;3\n", &["line 3: `1.6`", "decimal mark of the lines before"]),
        (
            "d [nm];F [nN]\n1.234,5;2\n1;3\n",
            &["line 2: `1.234,5` in the column `d` is not a number; write it without marks between the thousands"],
        ),
        ("d [nm];F [nN]\n1;nan\n1;3\n", &["`nan` in the column `F` is not a number; `missing = \"skip\"`"]),
        ("d [nm] F [nN]\n1 2\n3\n5 6\n", &["line 3: 1 columns"]),
        ("d [nm],F [nN]\n1.2.3,2\n3,4\n5,6\n", &["line 2: `1.2.3` in the column `d`"]),
        ("d [nm],F [nN]\n1,2\n3,nan\n5,6\n", &["line 3: `nan` in the column `F`"]),
        ("d [nm],F [nN]\n1,2\n3,\n5,6\n", &["line 3: there is no column 2"]),
        ("d [nm],F [nN]\n1,2\nEnd of data\n", &["line 3:"]),
        ("d [nm],F [nN]\nnm,mN\n1,2\n3,4\n", &["`nN` by its name and in `mN`"]),
        ("1,2\n3,4\nd [nm],F [nN]\n5,6\n", &["no units"]),
        (
            "1,2,approach\n3,4,approach\nd [nm],F [nN],leg\n5,6,retract\n",
            &["line 1 looks like a row above the header on line 3"],
        ),
        ("# segment: pause\nd [nm],F [nN]\n1,2\n", &["line 1: rows follow the segment `pause`"]),
        ("one word\n", &["no row of at least two numbers"]),
        ("", &["no row of at least two numbers"]),
        (&wide, &["line 3: `7x7x", "(1000 characters)"]),
        (bell, &["line 3 has the character 0x1b"]),
        (turned, &["line 3: `\\u{202e}1`"]),
    ] {
        let error = open(text.as_bytes(), "").expect_err(text);
        assert!(parts.iter().all(|part| error.contains(part)), "{text}: {error}");
        assert!(error.len() < 600, "{error}");
    }
    // Too long a line, too many rows.
    let long = [b"d [nm],F [nN]\n1,2\n".as_slice(), &b"1 ".repeat(1 << 20)].concat();
    assert!(open(&long, "").unwrap_err().contains("line 3 is longer than"));
    let many = [b"d [nm],F [nN]\n".as_slice(), &b"1,2\n".repeat(1_000_001)].concat();
    assert!(open(&many, "").unwrap_err().contains("1000001 rows; at most 1000000"));
}

/// SplitMix64 (Steele, Lea & Flood 2014).
struct Random(u64);

impl Random {
    /// A number below `end`.
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % end as u64) as usize
    }
}

/// Damaged files are read or refused on one line of limited length, and never panic.
#[test]
fn damaged_files_are_read_or_refused() {
    const PIECES: [&[u8]; 16] = [
        b"#",
        b"%",
        b";",
        b",",
        b"\t",
        b" ",
        b"\n",
        b"\r",
        b"\"",
        b"nm",
        b"[",
        b"]",
        b"# segment: x\n",
        b"# columns: a b\n",
        b"\xff\xfe",
        b"1e999",
    ];
    let seeds: [String; 4] = [
        format!("d [nm],F [nN]\n{}", rows(",", ".", None)),
        format!("Gain;3\nd;F\nnm;nN\n{}", rows(";", ",", Some(["extend", "retract"]))),
        format!("# segment: extend\n# columns: d F\n# units: nm nN\n{}", rows(" ", ".", None)),
        format!("\"d (x)\"\tF / µN\n{}", rows("\t", ",", None)),
    ];
    let mut random = Random(7);
    let mut read = 0;
    for _ in 0..4000 {
        let mut bytes = seeds[random.below(seeds.len())].clone().into_bytes();
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            match random.below(4) {
                0 => bytes[at] ^= 1 << random.below(8),
                1 => drop(bytes.drain(at..(at + 1 + random.below(9)).min(bytes.len()))),
                2 => {
                    let part = bytes[at..(at + 9).min(bytes.len())].to_vec();
                    bytes.splice(at..at, part);
                }
                _ => drop(bytes.splice(at..at, PIECES[random.below(PIECES.len())].iter().copied())),
            }
        }
        let data = ["", "columns = { x = \"d\", y = 2 }", "units = [\"nm\", \"nN\"]"][random.below(3)];
        match open(&bytes, data) {
            Ok(_) => read += 1,
            Err(error) => assert!(!error.contains('\n') && error.len() < 1500, "{error}"),
        }
    }
    // Neither everything nor nothing.
    assert!((200..3800).contains(&read), "{read}");
}
