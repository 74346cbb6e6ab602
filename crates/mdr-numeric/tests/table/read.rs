//! CSV tables: accepted ones, and rejected ones with their line and value.

use mdr_numeric::table::{Table, TableError, TableRow};

fn read(text: &str) -> Result<Table, TableError> {
    Table::from_csv(text.as_bytes())
}

/// Radii and heights as texts in metres.
fn rows(text: &str) -> Vec<(String, String)> {
    let exact = |row: &TableRow| (row.radius.to_string(), row.height.to_string());
    read(text).unwrap().rows().iter().map(exact).collect()
}

fn pairs(rows: &[(String, String)]) -> Vec<(&str, &str)> {
    rows.iter().map(|(r, f)| (r.as_str(), f.as_str())).collect()
}

#[test]
fn the_ways_to_write_a_table() {
    let expected = [("0", "0"), ("0.1", "1e-3"), ("0.2", "-.5"), ("0.3", "1/3")];
    for text in [
        "0,0\n0.1,1e-3\n0.2,-.5\n0.3,1/3\n",
        "r,f\n0,0\n0.1,1e-3\n0.2,-.5\n0.3,1/3",
        "\u{feff}R;F\r\n0;0\r\n0.1;1e-3\r\n\r\n0.2;-.5\r\n0.3;1/3\r\n",
        "# a tip\n\n  # measured, twice\nr\tf\nm\tm\n0\t0\n0.1\t1e-3\n# half way\n0.2\t-.5\n0.3\t1/3\n",
        "\"r\",\"f\"\n 0 , 0\n\"0.1\",\"1e-3\"\n0.2 , -.5\n0.3,1/3\n",
        "f,scan,r\n0,first,0\n1e-3,x,0.1\n-.5,,0.2\n1/3,nan,0.3\n",
        "m,m\n0,0\n0.1,1e-3\n0.2,-.5\n0.3,1/3\n",
    ] {
        assert_eq!(pairs(&rows(text)), expected, "{text:?}");
    }
}

#[test]
fn units_move_the_decimal_point() {
    let table = rows("r,f\n[µm],(nm)\n0,0\n1.5,20\n2e1,1e+3\n30,1/7\n");
    assert_eq!(pairs(&table), [("0e-6", "0e-9"), ("1.5e-6", "20e-9"), ("2e-5", "1e-6"), ("30e-6", "1/7000000000")]);
    let ordered = rows("f,r\nnm,um\n0,0\n20,1.5\n30,2\n40,3\n");
    assert_eq!(ordered[1], ("1.5e-6".to_owned(), "20e-9".to_owned()));
}

#[test]
fn rows_know_their_lines() {
    let lines = |text: &str| read(text).unwrap().rows().iter().map(|row| row.line).collect::<Vec<_>>();
    assert_eq!(lines("# c\n\n# d\nr,f\n\n#x\n1,2\n2,4\r\n\r\n5,6\n  # y\n7,8"), [7, 8, 10, 12]);
    assert_eq!(lines("1,2\n2,3\n3,4\n4,5\n"), [1, 2, 3, 4]);
}

/// Each message complete: line, column, value, remedy.
#[test]
fn refusals() {
    for (text, message) in [
        (
            "0,0\n1,1\n3,2\n2,3\n",
            "line 4, column r: the radius 2 is smaller than 3 on line 3; sort the rows by increasing r",
        ),
        (
            "r,f\nnm,nm\n0,0\n1,1\n# again\n1.0,2\n2,3\n",
            "line 6, column r: the radius 1.0 was already given on line 4; keep one of the two rows, or their mean",
        ),
        (
            "-1,1\n0,0\n1,1\n2,3\n",
            "line 1, column r: the radius -1 is negative; fold the trace at the tip, so that r ≥ 0 is the distance \
             from the axis",
        ),
        (
            "r,f\num,nm\n0,1.5\n1,1\n2,3\n3,4\n",
            "line 3, column f: the profile is not zero at the tip, f(0) = 1.5; subtract 1.5 from every f",
        ),
        ("0,0\n1,NaN\n2,3\n3,4\n", "line 2, column f: `NaN` is not finite: expected a decimal such as 0.25 or 1e-9"),
        ("0,0\n1,1\n2,2\n-inf,4\n", "line 4, column r: `-inf` is not finite: expected a decimal such as 0.25 or 1e-9"),
        (
            "0,0\n1,1\n2,2\n3,\n",
            "line 4, column f: `` is not a number: expected a decimal such as 0.25 or 1e-9, or a fraction of integers \
             such as 1/3",
        ),
        (
            "r,z\n0,0\n1,1\n2,2\n3,3\n",
            "line 1: no column `f` among `r, z`; the header must name the columns `r` and `f`",
        ),
        (
            "r,f\nm,V\n0,0\n1,1\n2,2\n3,3\n",
            "line 2, column f: unknown unit `V`; expected m, alone or with an SI prefix: nm, um, mm",
        ),
        (
            "r;f\n0;0\n1;1\n2\n3;3\n",
            "line 4: 1 fields where 2 are expected; columns are separated by a comma, a semicolon or a tab, decimals \
             are written with a point, and a table without header has the two columns r and f",
        ),
        (
            "# nothing but three rows\nr,f\n0,0\n1,1\n2,4\n",
            "3 rows of numbers; at least 4 are needed, because with fewer the slopes of the interpolant follow from \
             its end conditions and not from the data",
        ),
        (
            "",
            "0 rows of numbers; at least 4 are needed, because with fewer the slopes of the interpolant follow from \
             its end conditions and not from the data",
        ),
    ] {
        assert_eq!(read(text).unwrap_err().to_string(), message, "{text:?}");
    }
}

#[test]
fn more_refusals() {
    // Decimal commas, three columns without a header, a lone word, radii that differ only in exact arithmetic.
    assert!(matches!(read("0;0\n0,1;1\n2;2\n3;3\n"), Err(TableError::NotANumber { line: 2, .. })));
    assert!(matches!(read("0,0,1\n1,1,1\n2,2,2\n3,3,3\n"), Err(TableError::Width { line: 1, found: 3, .. })));
    assert!(matches!(read("r,f\n0,0\n1,high\n2,2\n3,3\n"), Err(TableError::NotANumber { line: 3, .. })));
    let twins = "0,0\n0.1,1\n0.10000000000000000001,2\n3,3\n";
    assert!(matches!(read(twins), Err(TableError::Repeated { line: 3, previous_line: 2, .. })));
    let latin1 = [b"r,f\n\xb5m,nm\n".as_slice(), b"0,0\n1,1\n2,2\n3,3\n"].concat();
    assert!(matches!(Table::from_csv(latin1.as_slice()), Err(TableError::Malformed { line: 2, .. })));
}
