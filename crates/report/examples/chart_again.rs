fn main() {
    for d in std::env::args().skip(1) {
        println!("{:?}", stratiform_report::build_chart(std::path::Path::new(&d)));
    }
}
