declare module "virtual:formulas" {
  const formulas: readonly import("../build/formulas.ts").TypesetFormula[];
  export default formulas;
}
declare module "virtual:formulas.css";
