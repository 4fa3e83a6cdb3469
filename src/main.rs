//! temporary
fn main() {
    let v = ray_test::registry::variants();
    println!("{}", v.len());
    for x in v.iter().step_by(40) {
        println!("{}", x.id());
    }
}
