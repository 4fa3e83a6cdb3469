//! Who is whose child: a hierarchy before its volumes are known. Every builder makes one.

/// A tree over triangles.
#[derive(Clone, Debug, Default)]
pub struct Topology {
    nodes: Vec<Branch>,
    root: usize,
}

/// A node of a tree.
#[derive(Clone, Debug)]
pub enum Branch {
    /// Triangles.
    Leaf(Vec<u32>),
    /// Nodes.
    Inner(Vec<usize>),
}

impl Topology {
    /// Of those nodes, of which each but the root is the child of exactly one other.
    pub fn new(nodes: Vec<Branch>, root: usize) -> Self {
        Topology { nodes, root }
    }

    /// The node at the top; `None` of nothing.
    pub fn root(&self) -> Option<usize> {
        (!self.nodes.is_empty()).then_some(self.root)
    }

    /// A node.
    pub fn branch(&self, node: usize) -> &Branch {
        &self.nodes[node]
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether it is a tree of nothing.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The triangles of every leaf, children in order.
    pub fn leaves(&self) -> Vec<&[u32]> {
        self.root().map_or_else(Vec::new, |root| self.leaves_below(root))
    }

    /// The triangles of every leaf below a node, children in order.
    pub fn leaves_below(&self, node: usize) -> Vec<&[u32]> {
        let mut leaves = Vec::new();
        let mut stack = vec![node];
        while let Some(node) = stack.pop() {
            match &self.nodes[node] {
                Branch::Leaf(triangles) => leaves.push(triangles.as_slice()),
                Branch::Inner(children) => stack.extend(children.iter().rev()),
            }
        }
        leaves
    }

    /// All nodes below the root and the root, children before their parents.
    pub fn children_first(&self) -> Vec<usize> {
        let mut order: Vec<usize> = self.root().into_iter().collect();
        let mut next = 0;
        while next < order.len() {
            if let Branch::Inner(children) = &self.nodes[order[next]] {
                order.extend(children);
            }
            next += 1;
        }
        order.reverse();
        order
    }
}
